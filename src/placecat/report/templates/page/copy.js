(() => {
  "use strict";
  // One header line, one line per row, and a separate column for the name of the group.
  const toText = (table) => {
    const bodies = [...table.tBodies];
    const grouped = bodies.some((body) => body.querySelector("tr.group"));
    const heads = [...table.tHead.querySelectorAll("th:not([data-skip])")].filter((one) => one.colSpan === 1);
    const lines = [heads.map((one) => one.dataset.head ?? one.textContent)];
    if (grouped) lines[0].unshift("");
    for (const body of bodies) {
      let group = "";
      for (const row of body.rows) {
        if (row.classList.contains("group")) {
          group = row.textContent;
          continue;
        }
        const cells = [...row.cells].filter((one) => !("skip" in one.dataset)).map((one) => one.textContent);
        lines.push(grouped ? [group, ...cells] : cells);
      }
    }
    const clean = (text) => text.replace(/\s+/g, " ").trim();
    return lines.map((line) => line.map(clean).join("\t")).join("\n") + "\n";
  };
  const select = (table) => {
    const range = document.createRange();
    range.selectNode(table);
    const selection = window.getSelection();
    selection.removeAllRanges();
    selection.addRange(range);
  };
  for (const button of document.querySelectorAll("button.copy")) {
    const table = button.closest(".table").querySelector("table");
    button.hidden = false;
    button.title = "Copy the table for a spreadsheet";
    button.addEventListener("click", async () => {
      let said = "Copied";
      try {
        await navigator.clipboard.writeText(toText(table));
      } catch {
        // Without permission to use the clipboard, select the table so that the user can copy it.
        select(table);
        said = "Selected";
      }
      button.textContent = said;
      setTimeout(() => (button.textContent = "Copy"), 2000);
    });
  }
})();
