"""The command line of the experiments: ``python -m placecat.experiment``, or ``placecat-experiment``."""

from placecat.experiment.application import main

if __name__ == "__main__":
    main()
