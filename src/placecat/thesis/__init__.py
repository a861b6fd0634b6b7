"""What the thesis says, beside what a run measured: tables, findings, numbers in the text."""
