import sys
from pathlib import Path

# For fake_categorizer.
sys.path.insert(0, str(Path(__file__).parent))
