import sys
from pathlib import Path

# Makes fake_categorizer importable.
sys.path.insert(0, str(Path(__file__).parent))
