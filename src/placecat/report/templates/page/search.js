(() => {
  "use strict";
  const SHOWN = 40;
  // Number of characters shown on either side of a match.
  const AROUND = 40;
  const box = document.querySelector(".search");
  const [input, found, list, count] = ["input", ".found", "ol", "output"].map((one) => box.querySelector(one));
  const clean = (text) => text.replace(/\s+/g, " ").trim();
  // textContent has no space between cells.
  const textOf = (elements) => {
    const parts = [];
    for (const one of elements) {
      const walker = document.createTreeWalker(one, NodeFilter.SHOW_TEXT);
      while (walker.nextNode()) parts.push(walker.currentNode.data);
    }
    return clean(parts.join(" "));
  };

  // For each kind: its name, a selector of its elements (their ids are link targets), a function that finds the
  // label of an element, and one that finds more to search.
  const KINDS = [
    ["section", "main > section", (one) => one.querySelector("h2"), () => []],
    ["table", ".table[id]", (one) => one.querySelector("h3, summary"), (one) => one.querySelectorAll("th, .notes")],
    ["figure", "figure[id]", (one) => one.querySelector("figcaption"), () => []],
    ["finding", "#ledger tbody tr", (one) => one.querySelector(".f-claim"), (one) => [one]],
    ["number in the text", "tr.group[id]", (one) => one, (one) => [one.parentElement]],
    ["setting", "#settings details", (one) => one.querySelector("summary"), (one) => one.querySelectorAll("pre")],
  ];
  let index = null;
  const makeIndex = () =>
    KINDS.flatMap(([kind, selector, label, more]) =>
      [...document.querySelectorAll(selector)]
        .filter((one) => one.id && label(one))
        .map((one) => ({ kind, id: one.id, label: textOf([label(one)]), text: textOf(more(one)) })),
    );

  const marked = (text, wanted) => {
    const parts = [];
    const lower = text.toLowerCase();
    let at = 0;
    while (at < text.length) {
      const next = wanted
        .map((word) => ({ start: lower.indexOf(word, at), length: word.length }))
        .filter(({ start }) => start >= 0)
        .sort((one, other) => one.start - other.start || other.length - one.length)[0];
      if (!next) break;
      const mark = document.createElement("mark");
      mark.textContent = text.slice(next.start, next.start + next.length);
      parts.push(text.slice(at, next.start), mark);
      at = next.start + next.length;
    }
    return [...parts, text.slice(at)];
  };

  const snippet = (entry, wanted) => {
    const word = wanted.find((one) => !entry.label.toLowerCase().includes(one));
    if (!word) return "";
    const at = entry.text.toLowerCase().indexOf(word);
    const [start, end] = [Math.max(0, at - AROUND), at + word.length + AROUND];
    return `${start ? "…" : ""}${entry.text.slice(start, end)}${end < entry.text.length ? "…" : ""}`;
  };

  const shownEntry = (entry, wanted) => {
    const [item, link, kind] = ["li", "a", "span"].map((name) => document.createElement(name));
    link.href = `#${entry.id}`;
    kind.className = "kind";
    kind.textContent = entry.kind;
    link.append(kind, ...marked(entry.label, wanted));
    const around = snippet(entry, wanted);
    if (around) {
      const small = document.createElement("small");
      small.append(...marked(around, wanted));
      link.append(small);
    }
    item.append(link);
    return item;
  };

  const close = () => {
    list.replaceChildren();
    found.hidden = true;
  };
  const search = () => {
    const wanted = input.value.toLowerCase().split(/\s+/).filter(Boolean);
    if (!wanted.length) return close();
    index ??= makeIndex();
    const has = (text) => wanted.every((word) => text.toLowerCase().includes(word));
    const named = index.filter((one) => has(one.label));
    const matches = [...named, ...index.filter((one) => !has(one.label) && has(`${one.label} ${one.text}`))];
    list.replaceChildren(...matches.slice(0, SHOWN).map((one) => shownEntry(one, wanted)));
    found.hidden = false;
    const more = matches.length > SHOWN ? `, the first ${SHOWN} shown` : "";
    count.textContent = `${matches.length || "No"} match${matches.length === 1 ? "" : "es"}${more}`;
  };

  input.addEventListener("input", search);
  input.addEventListener("focus", search);
  list.addEventListener("click", (event) => event.target.closest("a") && close());
  document.addEventListener("click", (event) => box.contains(event.target) || close());
  document.addEventListener("keydown", (event) => {
    const isTyping = event.target.closest?.("input, textarea, select, [contenteditable]");
    if (event.key === "/" && !isTyping && !event.ctrlKey && !event.metaKey && !event.altKey) {
      event.preventDefault();
      input.focus();
      input.select();
    }
  });
  box.addEventListener("keydown", (event) => {
    const links = [...list.querySelectorAll("a")];
    const at = links.indexOf(document.activeElement);
    if (event.key === "Escape") {
      input.value = "";
      input.focus();
      close();
    } else if (event.key === "Enter" && at < 0) {
      links[0]?.click();
    } else if (event.key === "ArrowDown" || event.key === "ArrowUp") {
      event.preventDefault();
      (links[at + (event.key === "ArrowDown" ? 1 : -1)] ?? (at > 0 ? links[at] : input)).focus();
    }
  });
})();
