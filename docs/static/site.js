// What Sphinx leaves out for readers without a mouse, without sight, or with a phone.

// The titles of the table of contents say that they are headings; this says of which level.
function nameLevels() {
  for (const title of document.querySelectorAll("[role=heading]:not([aria-level])")) {
    title.setAttribute("aria-level", "2");
  }
}

// A table of many columns becomes a list of cards on a phone: each cell knows the head of its column, and
// roles say what the display of its parts no longer says.
function labelCells() {
  for (const table of document.querySelectorAll("table.docutils")) {
    const heads = [...table.querySelectorAll("thead th")].map((head) => head.textContent.trim());
    if (heads.length < 4) continue;
    table.classList.add("stacks");
    table.setAttribute("role", "table");
    for (const part of table.querySelectorAll("thead, tbody")) part.setAttribute("role", "rowgroup");
    for (const row of table.rows) {
      row.setAttribute("role", "row");
      [...row.cells].forEach((cell, n) => {
        cell.setAttribute("role", cell.tagName === "TH" ? "columnheader" : "cell");
        cell.dataset.label = heads[n];
        if (["", "–"].includes(cell.textContent.trim())) cell.dataset.empty = "";
      });
    }
  }
}

// A picture that is shown smaller than it is opens in its own size; one of many frames in a row can be scrolled.
const LONG = 2;
function openPictures() {
  for (const picture of document.querySelectorAll("article img:not(a img)")) {
    const wide = picture.naturalWidth > LONG * picture.naturalHeight;
    if (!wide && picture.naturalWidth <= 1.2 * picture.clientWidth) continue;
    const link = document.createElement("a");
    link.href = picture.src;
    link.className = "zoom";
    // a picture for light or dark pages alone takes its place with it
    link.classList.add(...[...picture.classList].filter((name) => name.startsWith("only-")));
    link.title = "open in full size";
    picture.replaceWith(link);
    link.append(picture);
    if (!wide) continue;
    const strip = document.createElement("div");
    strip.className = "strip";
    link.replaceWith(strip);
    strip.append(link);
    strip.addEventListener("scroll", () => markCut(strip), { passive: true });
  }
}

// A box is cut where more of it lies to the right.
function markCut(box) {
  box.classList.toggle("cut", box.scrollLeft + box.clientWidth < box.scrollWidth - 1);
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
  document.querySelectorAll(".strip").forEach(markCut);
}

document.addEventListener("DOMContentLoaded", () => {
  nameLevels();
  labelCells();
  reachScrolling();
});
addEventListener("load", () => {
  openPictures();
  reachScrolling();
});
addEventListener("resize", reachScrolling);
