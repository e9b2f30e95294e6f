package org.urbi.web;

import java.util.regex.Pattern;

/**
 * By which names a page may be asked for. A page of another site can have its own name lead to this
 * machine, and then is of the same site for the browser. So a page for this machine has the names
 * of this machine alone. One for other machines has any name if tokens are asked for, which the
 * other site does not know. Without tokens it has names alone that no other site can own:
 * addresses, names without a dot, those of the local network, and the one that it was given.
 *
 * @param local whether the page is for this machine only
 * @param given where it was told to listen
 * @param open whether somebody is let in without a token
 */
record HostNames(boolean local, String given, boolean open) {
  private static final String PORT = "(:\\d+)?";
  private static final Pattern THIS_MACHINE = names("localhost|127(\\.\\d+){3}|\\[::1\\]");
  private static final Pattern NOBODY_ELSES =
      names(
          "\\d+(\\.\\d+){3}|\\[[\\da-f:.]+\\]|[\\w-]+"
              + "|[\\w.-]+\\.(local|localhost|internal|home\\.arpa)");

  private static Pattern names(String expression) {
    return Pattern.compile("(" + expression + ")" + PORT, Pattern.CASE_INSENSITIVE);
  }

  /**
   * Whether the page may be asked for by a name.
   *
   * @param host what a browser says: a name, perhaps with a port
   */
  boolean allow(String host) {
    if (local) {
      return THIS_MACHINE.matcher(host).matches();
    }
    return !open
        || NOBODY_ELSES.matcher(host).matches()
        || names(Pattern.quote(given)).matcher(host).matches();
  }
}
