import sys
from pathlib import Path

# This makes worlds.py importable.
sys.path.insert(0, str(Path(__file__).parent))
