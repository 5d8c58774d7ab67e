// play.save(name, text): a file to keep, as if it had been downloaded. Nothing leaves the machine.
"use strict";

(() => {
  const play = (globalThis.Raysteps ??= {}).play ??= {};

  function save(name, text) {
    const address = URL.createObjectURL(new Blob([text], { type: "application/json" }));
    Object.assign(document.createElement("a"), { href: address, download: name }).click();
    setTimeout(() => URL.revokeObjectURL(address), 10000);
  }

  Object.assign(play, { save });
})();
