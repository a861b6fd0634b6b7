"""Sweepers, placed where Hydra looks for plugins. Hydra always imports them, so slow imports are deferred."""

import sys
from abc import abstractmethod
from typing import TYPE_CHECKING

from hydra.plugins.sweeper import Sweeper
from hydra.types import HydraContext, TaskFunction
from omegaconf import DictConfig

if TYPE_CHECKING:
    from collections.abc import Sequence

    from hydra.plugins.launcher import Launcher


class _Checked(Sweeper):
    """A sweeper that exits with one message if an experiment is invalid, and with status 1 if one fails."""

    def setup(self, *, hydra_context: HydraContext, task_function: TaskFunction, config: DictConfig) -> None:
        """Store the Hydra context and settings, and create the launcher."""
        from hydra.core.plugins import Plugins

        self.hydra_context: HydraContext = hydra_context
        self.config: DictConfig = config
        self.launcher: Launcher = Plugins.instance().instantiate_launcher(
            hydra_context=hydra_context, task_function=task_function, config=config
        )

    def sweep(self, arguments: list[str]) -> None:
        """Check, run and report; `arguments` are the command-line overrides."""
        from placecat.errors import PlacecatError

        try:
            is_well = self.run(arguments)
        except PlacecatError as error:
            sys.exit(f"placecat: {error}")
        if not is_well:
            sys.exit(1)

    def launch(self, lines: "Sequence[Sequence[str]]") -> None:
        """Run jobs with these overrides."""
        self.launcher.launch(lines, initial_job_idx=0)

    def logged(self, arguments: "Sequence[str]") -> "Sequence[str] | None":
        """Return the sweeper and overrides, which identify the sweep in MLflow, or None if not logged."""
        return [str(self.config.hydra.sweeper._target_), *arguments] if self.config.track else None

    @abstractmethod
    def run(self, arguments: list[str]) -> bool:
        """Check, run and report; return whether all experiments succeeded."""


class GridSweeper(_Checked):
    """Check all combinations, then run them as Hydra's basic sweeper does."""

    def run(self, arguments: list[str]) -> bool:
        """Run the combinations."""
        from placecat.experiment import jobs, summary, sweep

        lines, combinations = sweep.grid(arguments, self.hydra_context.config_loader)
        experiments = sweep.check(self.config, lines, combinations)
        for own, experiment in zip(combinations, experiments, strict=True):
            if own.get(summary.HOME, "all") != "all":
                # Show the home's name as spelled in the data set, not as the user typed it.
                own[summary.HOME] = "+".join(experiment.homes)
        with sweep.begun(self.config, combinations) as folder:
            jobs.run(folder, lines, experiments, self.launch)
            return summary.tell(folder, combinations, log=self.logged(arguments))


class OptunaSweeper(_Checked):
    """Choose the settings of each experiment with Optuna, based on the accuracies of earlier experiments.

    Unlike Hydra's own plugin, which needs Optuna 2, it first tries the settings used without a search, and
    its batches do not depend on the number of workers. The parameters are described in
    conf/hydra/sweeper/optuna.yaml.
    """

    def __init__(self, digits: int, params: DictConfig | None = None, **numbers: int) -> None:
        self.numbers = numbers
        self.digits = digits
        self.params = {str(key): value for key, value in (params or {}).items()}

    def run(self, arguments: list[str]) -> bool:
        """Run the search and write its result to the sweep's folder."""
        from placecat import settings
        from placecat.experiment import jobs, summary, sweep
        from placecat.search import report, space, study

        config = self.config
        space.check(config)
        own = space.read(self.params, arguments, config, settings.load(), digits=self.digits)
        ends = [[*own.fixed, *line] for line in own.ends()]
        sweep.check(config, ends, [space.values(line) for line in own.ends()])
        started: list[dict[str, str]] = []

        def launch(lines: "Sequence[tuple[str, ...]]", first: int) -> list[float]:
            started.extend(space.values(line) for line in lines)
            whole = [[*own.fixed, *line] for line in lines]
            experiments = [sweep.meant(config, line) for line in whole]
            return jobs.run(folder, whole, experiments, self.launch, first=first)

        with sweep.begun(config, started) as folder:
            tried = study.search(own, launch, **self.numbers)
            choices = config.hydra.runtime.choices
            base = {key: str(choices[key]) for key in ("descriptor", "classifier", "data") if key in choices}
            home = config.test_home if isinstance(config.test_home, str | int) else config.test_home[0]
            print(f"\n{report.write(folder, tried, own, base, str(home))}")
            return summary.tell(folder, started, log=self.logged(arguments))
