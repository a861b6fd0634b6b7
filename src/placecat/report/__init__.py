"""Reports: figures, charts, the HTML page, and tables in LaTeX and Markdown."""
