import sys
from pathlib import Path

# For worlds.
sys.path.insert(0, str(Path(__file__).parent))
