(() => {
  "use strict";
  // This runs in the head of the page, so the page never starts in the wrong colours.
  const root = document.documentElement;
  const system = matchMedia("(prefers-color-scheme: dark)");
  const remembered = () => {
    try {
      return localStorage.getItem("placecat-theme") ?? "";
    } catch {
      return ""; // A browser may refuse to store settings for a local file.
    }
  };
  const apply = (theme) => (root.style.colorScheme = theme);
  const isDark = () => (root.style.colorScheme ? root.style.colorScheme === "dark" : system.matches);
  apply(remembered());
  addEventListener("DOMContentLoaded", () => {
    const button = document.querySelector("button.theme");
    const name = () => (button.textContent = isDark() ? "Light" : "Dark");
    button.addEventListener("click", () => {
      const theme = isDark() ? "light" : "dark";
      apply(theme);
      try {
        localStorage.setItem("placecat-theme", theme);
      } catch {
        // The choice lasts until the user leaves the page.
      }
      name();
    });
    system.addEventListener("change", name);
    button.closest(".tools").hidden = false;
    name();
  });
})();
