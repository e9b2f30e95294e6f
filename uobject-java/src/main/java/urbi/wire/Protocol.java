package urbi.wire;

/** The constants of the UObject protocol (docs/protocol.md). */
public final class Protocol {
  /** How the line starts with which a client asks for the protocol. */
  public static final String REQUEST = "\"urbi-uobject ";

  /** The channel on which a server answers. */
  public static final String CHANNEL = "uobject";

  /** The lowest version that this implementation speaks. */
  public static final int MIN_VERSION = 1;

  /** The highest version that this implementation speaks. */
  public static final int MAX_VERSION = 1;

  /** No frame is longer. */
  public static final int MAX_FRAME = 256 << 20;

  /** Seconds of silence after which a side asks the other for a sign of life. */
  public static final int SILENCE_SECONDS = 5;

  /** Seconds of silence after which the other side is given up. */
  public static final int TIMEOUT_SECONDS = 15;

  private Protocol() {}

  /** The line with which a client asks for the protocol. */
  public static String request() {
    return REQUEST + MIN_VERSION + " " + MAX_VERSION + "\";\n";
  }

  /**
   * The highest version that both speak; 0 if there is none.
   *
   * @param request what follows {@link #REQUEST}, up to the line's end
   */
  public static int agree(String request) {
    String[] versions = request.replaceAll("\"?;?\\s*$", "").split(" ");
    if (versions.length != 2
        || !versions[0].matches("\\d{1,6}")
        || !versions[1].matches("\\d{1,6}")) {
      return 0;
    }
    int highest = Math.min(MAX_VERSION, Integer.parseInt(versions[1]));
    return highest >= Math.max(MIN_VERSION, Integer.parseInt(versions[0])) ? highest : 0;
  }
}
