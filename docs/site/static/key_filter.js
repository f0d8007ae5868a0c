// Key reference: a field that searches keys and meanings, and a choice of the model. Without it all tables are shown.
document.addEventListener("DOMContentLoaded", () => {
  const place = document.querySelector("p.key-filter");
  if (!place) return;
  const sections = [];
  for (const section of document.querySelectorAll("section"))
    if (section.querySelector(":scope > h2") && place.compareDocumentPosition(section) & Node.DOCUMENT_POSITION_FOLLOWING)
      sections.push(section);
  const name = (section) => section.querySelector("h2").firstChild.textContent.trim();
  const words = Object.assign(document.createElement("input"),
                              {type: "search", placeholder: "key or meaning, such as clearance", ariaLabel: "search keys"});
  const model = Object.assign(document.createElement("select"), {ariaLabel: "model"});
  model.append(new Option("all models", ""), ...sections.map((section) => new Option(name(section), name(section))));
  const count = document.createElement("span");
  place.append("Keys with ", words, " of ", model, " ", count);
  const show = () => {
    const wanted = words.value.toLowerCase().split(/\s+/).filter(Boolean);
    let found = 0;
    for (const section of sections) {
      let inSection = 0;
      for (const row of section.querySelectorAll("tbody tr")) {
        const text = row.textContent.toLowerCase();
        const shown = wanted.every((word) => text.includes(word));
        row.hidden = !shown;
        inSection += shown;
      }
      const chosen = !model.value || model.value === name(section);
      section.hidden = !chosen || inSection === 0;
      if (chosen) found += inSection;
    }
    count.textContent = `${found} keys`;
  };
  words.addEventListener("input", show);
  model.addEventListener("change", show);
  show();
});
