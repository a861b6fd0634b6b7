(() => {
  "use strict";
  const content = JSON.parse(document.getElementById("explanations").textContent);
  const dialog = document.getElementById("explanation");
  const linesOf = (number) => content.cells[number].flatMap((item) =>
    Array.isArray(item) ? [item] : content.blocks[item].map((line) => content.lines[line]));
  const element = (name, text) => Object.assign(document.createElement(name), { textContent: text });
  const show = (number) => {
    const list = dialog.querySelector("dl");
    list.replaceChildren();
    for (const [label, text] of linesOf(number)) {
      if (label !== "stages") {
        list.append(element("dt", label), element("dd", text));
        continue;
      }
      for (const stage of text.split(" ")) {
        const made = content.stages[stage];
        list.append(element("dt", `stage ${stage}`), element("dd", made ? `made from ${made}` : "not in dvc.lock"));
      }
    }
    dialog.querySelector("h3").textContent = number;
    dialog.querySelector("code").textContent = `placecat explain ${number}`;
    dialog.showModal();
    dialog.scrollTop = 0;
    history.replaceState(null, "", `#${number}`);
  };
  dialog.querySelector("button").addEventListener("click", () => dialog.close());
  // A click on the backdrop targets the dialog itself; a click on its content targets an inner element.
  dialog.addEventListener("click", (event) => event.target === dialog && dialog.close());
  dialog.addEventListener("close", () => history.replaceState(null, "", location.pathname + location.search));

  // Number the cells like placecat.provenance.numbering does, before sorting moves rows.
  for (const table of document.querySelectorAll("table[data-name]")) {
    const name = table.dataset.name;
    const rows = [...table.tBodies].flatMap((body) => [...body.rows]).filter((row) => !row.matches(".group"));
    let first = true;
    rows.forEach((row, r) => {
      [...row.cells].filter((cell) => cell.matches("td:not(.thesis):not(.words)")).forEach((cell, c) => {
        const number = name === "in_text" ? `${name}.${r + 1}` : `${name}.${r + 1}.${c + 1}`;
        if (!(number in content.cells)) return;
        cell.id = number;
        cell.classList.add("explained");
        // The Tab key stops once per table; arrows move from cell to cell.
        cell.tabIndex = first ? 0 : -1;
        cell.setAttribute("aria-haspopup", "dialog");
        first = false;
      });
    });
  }
  const cellAt = (target) => {
    const cell = target.closest?.("td");
    return cell?.matches(".thesis") ? cell.previousElementSibling : cell;
  };
  document.addEventListener("click", (event) => {
    const cell = cellAt(event.target);
    if (cell?.matches(".explained") && getSelection().isCollapsed) show(cell.id);
  });
  const beside = (cell, key) => {
    const row = [...cell.parentElement.querySelectorAll(".explained")];
    if (key === "ArrowLeft" || key === "ArrowRight") return row[row.indexOf(cell) + (key === "ArrowRight" ? 1 : -1)];
    const rows = [...cell.closest("table").rows].filter((one) => one.querySelector(".explained"));
    const other = rows[rows.indexOf(cell.parentElement) + (key === "ArrowDown" ? 1 : -1)];
    return other && [...other.querySelectorAll(".explained")].at(row.indexOf(cell));
  };
  document.addEventListener("keydown", (event) => {
    const cell = event.target;
    if (!cell.matches?.(".explained") || event.altKey || event.ctrlKey || event.metaKey) return;
    if (event.key === "Enter" || event.key === " ") {
      event.preventDefault();
      show(cell.id);
    } else if (event.key.startsWith("Arrow")) {
      const next = beside(cell, event.key);
      if (!next) return;
      event.preventDefault();
      cell.tabIndex = -1;
      next.tabIndex = 0;
      next.focus();
    }
  });
  const followLink = () => {
    const number = decodeURIComponent(location.hash.slice(1));
    if (!(number in content.cells) || dialog.open) return;
    document.getElementById(number)?.scrollIntoView({ block: "center" });
    show(number);
  };
  addEventListener("hashchange", followLink);
  followLink();
})();
