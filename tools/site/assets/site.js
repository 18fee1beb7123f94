// Light or dark as the reader chose, the contents open where there is room, and a search over all headings and their text.
"use strict";

const store = {
  get: () => { try { return localStorage.getItem("theme"); } catch { return null; } },
  set: (theme) => { try { localStorage.setItem("theme", theme); } catch { /* not kept */ } },
};
const isDark = matchMedia("(prefers-color-scheme: dark)");
const show = () => (document.documentElement.dataset.theme = store.get() ?? (isDark.matches ? "dark" : "light"));
show();
isDark.addEventListener("change", show);

function findings(text) {
  const wanted = text.toLowerCase().split(/\s+/).filter(Boolean);
  const scored = WORDS.map((section) => {
    const [, title, , heading, words] = section;
    const places = [title, heading, words].map((part) => part.toLowerCase());
    const scores = wanted.map((word) => (places[1].includes(word) ? 4 : 0) + (places[0].includes(word) ? 2 : 0) + (places[2].includes(word) ? 1 : 0));
    return [Math.min(...scores) > 0 ? scores.reduce((sum, one) => sum + one, 0) : 0, section];
  });
  return wanted.length ? scored.filter(([score]) => score > 0).sort((a, b) => b[0] - a[0]).slice(0, 12) : [];
}

function search(input, list) {
  list.replaceChildren(...findings(input.value).map(([, [page, title, anchor, heading]]) => {
    const link = document.createElement("a");
    link.href = `${page}.html#${anchor}`;
    link.textContent = heading === title ? title : `${title}: ${heading}`;
    const item = document.createElement("li");
    item.append(link);
    return item;
  }));
  list.hidden = !input.value;
  if (input.value && !list.childElementCount) list.textContent = "Nothing found";
}

document.addEventListener("DOMContentLoaded", () => {
  document.getElementById("theme").addEventListener("click", () => {
    store.set(document.documentElement.dataset.theme === "dark" ? "light" : "dark");
    show();
  });
  const side = document.getElementById("contents");
  const wide = matchMedia("(min-width: 900px)");
  const open = () => (side.open = wide.matches && !document.body.classList.contains("start"));
  open();
  const current = side.querySelector("[aria-current]");
  if (current && wide.matches) side.scrollTop = current.offsetTop - side.clientHeight / 2;
  wide.addEventListener("change", open);
  const [input, list] = [document.getElementById("search"), document.getElementById("found")];
  input.addEventListener("focus", () => {
    const words = document.createElement("script");
    words.src = "assets/words.js";
    words.onload = () => input.addEventListener("input", () => search(input, list)) ?? search(input, list);
    document.head.append(words);
  }, { once: true });
  document.addEventListener("keydown", (event) => {
    if (event.key === "Escape") list.hidden = true;
    if (event.key === "/" && document.activeElement !== input) { event.preventDefault(); input.focus(); }
    if (event.key === "Enter" && document.activeElement === input) list.querySelector("a")?.click();
  });
  document.addEventListener("click", (event) => (list.hidden = list.hidden || !event.target.closest(".search")));
});
