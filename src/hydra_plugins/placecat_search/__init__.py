"""The sweeper of the searches, where Hydra looks for it. Hydra imports it always: nothing slow at the top."""

import logging
from pathlib import Path
from typing import TYPE_CHECKING, Any

from hydra.plugins.sweeper import Sweeper
from hydra.types import HydraContext, TaskFunction
from omegaconf import DictConfig, OmegaConf

if TYPE_CHECKING:
    from collections.abc import Sequence

_log = logging.getLogger(__name__)


class OptunaSweeper(Sweeper):
    """Choose each experiment's settings by the accuracies of those before, with Optuna.

    Unlike Hydra's own plugin, which needs Optuna 2, it tries the setting without a search first, and its
    batches do not depend on the number of workers, which is the launcher's. The parameters are those of
    conf/hydra/sweeper/optuna.yaml.
    """

    def __init__(
        self,
        n_trials: int,
        batch_size: int,
        seed: int,
        n_startup_trials: int,
        digits: int,
        params: DictConfig | None = None,
    ) -> None:
        self.n_trials = n_trials
        self.batch_size = batch_size
        self.seed = seed
        self.n_startup_trials = n_startup_trials
        self.digits = digits
        self.params = {str(key): value for key, value in (params or {}).items()}

    def setup(self, *, hydra_context: HydraContext, task_function: TaskFunction, config: DictConfig) -> None:
        """Take what Hydra gives."""
        from hydra.core.plugins import Plugins

        self.hydra_context = hydra_context
        self.config = config
        self.launcher = Plugins.instance().instantiate_launcher(
            hydra_context=hydra_context, task_function=task_function, config=config
        )

    def sweep(self, arguments: list[str]) -> Any:
        """Search, and write what was found to the folder of the sweep.

        Parameters
        ----------
        arguments
            Overrides of the command line.

        Returns
        -------
        list
            What was tried, see :class:`placecat.search.study.Tried`.

        Raises
        ------
        PlacecatError
            The search is refused, see :func:`placecat.search.requirements.check`.
        """
        from placecat import settings
        from placecat.search import report, requirements, space, study

        config = self.config
        assert config is not None
        requirements.need_optuna()
        own = space.read(self.params, arguments, config, settings.load(), digits=self.digits)
        requirements.check(config)
        folder = Path(config.hydra.sweep.dir)
        folder.mkdir(parents=True, exist_ok=True)
        OmegaConf.save(config, folder / "multirun.yaml")

        def run(lines: "Sequence[tuple[str, ...]]", first: int) -> list[float]:
            batch = [[*own.fixed, *line] for line in lines]
            # A wrong combination shows here, before others of the batch are computed.
            self.validate_batch_is_legal(batch)
            assert self.launcher is not None
            returns = self.launcher.launch(batch, initial_job_idx=first)
            return [float(one.return_value) for one in returns]

        tried = study.search(
            own,
            run,
            n_trials=self.n_trials,
            batch_size=self.batch_size,
            seed=self.seed,
            n_startup_trials=self.n_startup_trials,
        )
        choices = config.hydra.runtime.choices
        base = {key: str(choices[key]) for key in ("descriptor", "classifier", "data") if key in choices}
        home = config.test_home if isinstance(config.test_home, str) else config.test_home[0]
        text = report.write(folder, tried, own, base, home)
        _log.info("Written to %s:\n\n%s", folder / report.SUMMARY, text)
        return tried
