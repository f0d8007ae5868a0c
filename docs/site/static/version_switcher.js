// A choice of the versions that versions.js lists (docs/site/versions.py); nothing where there is one alone.
document.addEventListener("DOMContentLoaded", () => {
  const place = document.querySelector("p.versions"), versions = window.orbearingVersions || [];
  if (!place || versions.length < 2) return;
  const choice = Object.assign(document.createElement("select"), {ariaLabel: "version"});
  choice.append(...versions.map(({name, page, here}) => new Option(name, page, here, here)));
  choice.addEventListener("change", () => {
    location.href = place.dataset.root + choice.value;
  });
  place.append("Version ", choice);
});
