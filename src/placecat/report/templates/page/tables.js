(() => {
  "use strict";
  // A range may follow a number: "1.70 (1.60 to 1.90)".
  const NUMBER = /^[+−-]?\d[\d,]*(?:\.\d+)?(?= \(|$)/;
  // Smaller tables need no filter.
  const FILTERED_FROM = 8;
  const words = new Intl.Collator("en", { numeric: true });
  const clean = (text) => text.replace(/\s+/g, " ").trim();
  const isGroup = (row) => row.classList.contains("group");

  const read = (row, column) => {
    const cell = row.cells[column];
    const text = clean(cell?.dataset.value ?? cell?.textContent ?? "");
    return text === "n/a" ? "" : text;
  };
  const toNumber = (text) => Number(NUMBER.exec(text)[0].replaceAll(",", "").replace("−", "-"));

  // Rows that move together: a row, and the rows below it that explain it.
  const bundles = (body) => {
    const found = [];
    for (const row of body.rows) {
      if (isGroup(row)) continue;
      if (found.length && row.querySelector("td[colspan]")) found.at(-1).push(row);
      else found.push([row]);
    }
    return found;
  };

  const makeSortable = (table) => {
    const original = new Map([...table.tBodies].map((body) => [body, bundles(body)]));
    const heads = [...table.tHead.querySelectorAll("th")];
    const leaves = heads.filter((one) => one.colSpan === 1);

    const sort = (head) => {
      const next = { ascending: "descending", descending: "" }[head.ariaSort] ?? "ascending";
      leaves.forEach((one) => one.removeAttribute("aria-sort"));
      if (next) head.ariaSort = next;
      const column = leaves.indexOf(head);
      const texts = [...original.values()].flat().map(([row]) => read(row, column)).filter(Boolean);
      const isNumeric = head.dataset.sort !== "text" && texts.every((text) => NUMBER.test(text));
      const sign = next === "descending" ? -1 : 1;
      const compare = ([one], [other]) => {
        // Averages and missing numbers stay at the end.
        const isLast = (row) => Number(row.classList.contains("average"));
        if (isLast(one) !== isLast(other)) return isLast(one) - isLast(other);
        const [a, b] = [read(one, column), read(other, column)];
        if (!a || !b) return Number(!a) - Number(!b);
        return sign * (isNumeric ? toNumber(a) - toNumber(b) : words.compare(a, b));
      };
      for (const [body, rows] of original) {
        body.append(...(next ? rows.toSorted(compare) : rows).flat());
      }
    };

    let column = 1; // The first cell below a head that spans several columns.
    for (const head of heads) {
      let target = head;
      if (head.colSpan > 1) {
        target = leaves[column];
        column += head.colSpan;
      }
      if ("skip" in head.dataset || head.dataset.sort === "none") continue;
      const button = document.createElement("button");
      button.className = "sort";
      button.type = "button";
      button.title = "Sort";
      button.append(...head.childNodes);
      if (!button.textContent) button.ariaLabel = "Sort by name";
      button.addEventListener("click", () => sort(target));
      head.append(button);
    }
  };

  const makeFilter = (table, box) => {
    const title = box.querySelector(".title");
    const input = document.createElement("input");
    const count = document.createElement("output");
    input.type = "search";
    input.className = "filter";
    input.placeholder = "Filter rows";
    input.ariaLabel = `Filter rows of: ${clean(box.querySelector("h3, summary").textContent)}`;
    const rows = [...table.tBodies].flatMap((body) => {
      const group = [...body.rows].find(isGroup);
      return bundles(body).map((bundle) => {
        const cells = [group, ...bundle].flatMap((row) => [...(row?.cells ?? [])]);
        return { bundle, text: clean(cells.map((cell) => cell.textContent).join(" ")).toLowerCase() };
      });
    });
    input.addEventListener("input", () => {
      const wanted = input.value.toLowerCase().split(/\s+/).filter(Boolean);
      let shown = 0;
      for (const { bundle, text } of rows) {
        const matches = wanted.every((word) => text.includes(word));
        bundle.forEach((row) => (row.hidden = !matches));
        shown += Number(matches);
      }
      for (const body of table.tBodies) {
        body.hidden = [...body.rows].every((row) => row.hidden || isGroup(row));
      }
      count.textContent = wanted.length ? `${shown} of ${rows.length}` : "";
    });
    title.querySelector("button.copy").before(count, input);
  };

  for (const table of document.querySelectorAll(".table table:not([data-fixed])")) {
    makeSortable(table);
    const box = table.closest(".table");
    if (table.tBodies.length && table.querySelectorAll("tbody tr:not(.group)").length >= FILTERED_FROM) {
      makeFilter(table, box);
    }
  }

  // Show the target of a link, even if it is folded or filtered away.
  const reveal = () => {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    if (!target) return;
    for (let one = target; one; one = one.parentElement) {
      if (one.tagName === "DETAILS") one.open = true;
    }
    const input = target.closest(".table")?.querySelector("input.filter");
    if (input?.value) {
      input.value = "";
      input.dispatchEvent(new Event("input"));
    }
    target.scrollIntoView();
  };
  addEventListener("hashchange", reveal);
  if (location.hash) reveal();
})();
