// What the browser keeps for this page: "local", or only for this tab, "session". Where people have forbidden that, or there is no room,
// nothing is kept, and all else works.

export function kept(where, name) {
  try {
    return window[`${where}Storage`].getItem(name);
  } catch {
    return null;
  }
}

export function keep(where, name, value) {
  try {
    window[`${where}Storage`].setItem(name, value);
  } catch {
    // It is as if the page had been opened for the first time when it is opened again.
  }
}

export function forget(where, name) {
  try {
    window[`${where}Storage`].removeItem(name);
  } catch {
    // There is nothing to forget.
  }
}
