// What Sphinx leaves out for readers without a mouse or without sight.

// The titles of the table of contents say that they are headings; this says of which level.
function nameLevels() {
  for (const title of document.querySelectorAll("[role=heading]:not([aria-level])")) {
    title.setAttribute("aria-level", "2");
  }
}

// What is wider than the page scrolls with the arrow keys, once it can have the focus.
function reachScrolling() {
  for (const box of document.querySelectorAll("pre, .table-wrapper, .highlight, div.math")) {
    if (box.scrollWidth > box.clientWidth) {
      box.tabIndex = 0;
    } else {
      box.removeAttribute("tabindex");
    }
  }
}

document.addEventListener("DOMContentLoaded", () => {
  nameLevels();
  reachScrolling();
});
addEventListener("load", reachScrolling);
addEventListener("resize", reachScrolling);
