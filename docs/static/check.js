// The checker of certificates, run by Pyodide in a worker of the reader's own browser. Everything lies in the folder `check`.
const WORKER = `
  import { loadPyodide } from "BASE/pyodide.mjs";
  const ready = (async () => {
    const python = await loadPyodide({ indexURL: "BASE/" });
    const answer = await fetch("BASE/checker.zip");
    python.unpackArchive(await answer.arrayBuffer(), "zip");
    python.runPython(\`
from hfield.checker.check import check
from hfield.checker.json_text import read_json
from hfield.checker.rejection import Rejected
from hfield.checker.budget import Budget, bounded

def judged(text):
    most = Budget()
    try:
        with bounded(most):
            data = read_json(text)
        found = check(data, None, most)
    except Rejected as error:
        return "rejected", f"rejected: {error}"
    return ("assumes" if found.assumptions else "accepted"), str(found)
\`);
    return python.globals.get("judged");
  })();
  ready.then(() => postMessage({ ready: true }), (error) => postMessage({ failed: String(error) }));
  onmessage = async (event) => {
    const judged = await ready;
    const [verdict, text] = judged(event.data.text).toJs();
    postMessage({ name: event.data.name, verdict, text });
  };
`;
const SIGNS = { accepted: "✓ accepted", rejected: "✗ rejected", assumes: "? accepted under an assumption" };

function start(panel) {
  const base = new URL("check", document.baseURI).href;
  const code = new Blob([WORKER.replaceAll("BASE", base)], { type: "text/javascript" });
  const worker = new Worker(URL.createObjectURL(code), { type: "module" });
  const said = panel.querySelector("[role=status]");
  const list = panel.querySelector("ol");
  worker.onmessage = ({ data }) => {
    if (data.failed) {
      said.textContent = "Python did not start here: a browser opens it from a server alone, and this site may lack it. " +
        "In a shell: hfield check FILE";
      return;
    }
    if (data.ready) {
      said.textContent = "The checker is ready.";
      return;
    }
    said.textContent = `${data.name}: ${SIGNS[data.verdict]}`;
    const entry = document.createElement("li");
    const head = document.createElement("strong");
    head.textContent = `${data.name}: ${SIGNS[data.verdict]}`;
    const body = document.createElement("pre");
    body.textContent = data.text;
    entry.dataset.verdict = data.verdict;
    entry.append(head, body);
    list.prepend(entry);
  };
  worker.onerror = () => worker.onmessage({ data: { failed: true } });
  const ask = (name, text) => {
    said.textContent = `checking ${name} …`;
    worker.postMessage({ name, text });
  };
  const read = async (files) => {
    for (const file of files) ask(file.name, await file.text());
  };
  panel.querySelector("input[type=file]").onchange = (event) => read(event.target.files);
  panel.ondragover = (event) => event.preventDefault();
  panel.ondrop = (event) => {
    event.preventDefault();
    read(event.dataTransfer.files);
  };
  for (const button of panel.querySelectorAll("button[data-certificate]")) {
    button.onclick = async () => {
      const name = `${button.dataset.certificate}.json`;
      ask(name, await (await fetch(`${base}/${name}`)).text());
    };
  }
}

document.addEventListener("DOMContentLoaded", () => {
  const panel = document.getElementById("checker");
  if (panel) start(panel);
});
