// Files that the reader chooses or drops.

/** `take(name, file)` gets each file, `name` being 'fixed' or 'moved'. */
export function listen(take) {
  const zones = document.getElementById('zones');
  for (const name of ['fixed', 'moved']) {
    const input = document.getElementById(name);
    input.addEventListener('change', () => input.files.length > 0 && take(name, input.files[0]));
    const zone = zones.querySelector(`[data-body=${name}]`);
    zone.addEventListener('dragover', () => zone.classList.add('over'));
    zone.addEventListener('dragleave', () => zone.classList.remove('over'));
    zone.addEventListener('drop', (event) => {
      event.preventDefault();
      zone.classList.remove('over');
      const [first, second] = event.dataTransfer.files;
      const other = name === 'fixed' ? 'moved' : 'fixed';
      if (first) {
        take(name, first);
      }
      if (second) {
        take(other, second);
      }
    });
  }
  window.addEventListener('dragenter', () => { zones.hidden = false; });
  window.addEventListener('dragover', (event) => event.preventDefault());
  window.addEventListener('dragleave', (event) => { zones.hidden = event.relatedTarget === null; });
  window.addEventListener('drop', (event) => {
    event.preventDefault();
    zones.hidden = true;
  });
}
