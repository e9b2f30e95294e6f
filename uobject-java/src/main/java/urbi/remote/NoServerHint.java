package urbi.remote;

import urbi.ServerConnection;

/** What somebody can do who has met no server at an address: for the programs of the product. */
public final class NoServerHint {
  private NoServerHint() {}

  /** What follows the message that nobody answered there. */
  public static String text(String host, int port) {
    return " (is a server running there? urbi "
        + (ServerConnection.isFile(host) ? "--socket " + host : "--port " + port)
        + " starts one)";
  }
}
