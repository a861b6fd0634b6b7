"""``python -m placecat.replication``: print the power of each finding on 24 homes, from results in git."""

from placecat.files import read_table
from placecat.paths import COMPARISONS
from placecat.replication import options
from placecat.replication.needed import markdown, power_table

if __name__ == "__main__":
    print(markdown(power_table(read_table(COMPARISONS), 24, options.read())))
