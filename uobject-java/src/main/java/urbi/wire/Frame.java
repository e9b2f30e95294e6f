package urbi.wire;

/** The kinds of frames, by the byte that they start with (docs/protocol.md). */
public final class Frame {
  private Frame() {}

  // From either side.
  public static final int PING = 1;
  public static final int PONG = 2;
  public static final int LEFT = 3;

  // From the remote process.
  public static final int CLASS = 16;
  public static final int ATTACH = 17;
  public static final int DETACH = 18;
  public static final int BIND = 19;
  public static final int RESULT = 20;
  public static final int ERROR = 21;
  public static final int OPEN = 22;
  public static final int CLOSE = 23;
  public static final int SET = 24;
  public static final int OWN = 25;
  public static final int WATCH = 26;
  public static final int INTERCEPT = 27;
  public static final int SYNC = 28;
  public static final int GET_PROPERTY = 29;
  public static final int SET_PROPERTY = 30;
  public static final int EVENT = 31;
  public static final int EMIT = 32;
  public static final int CODE = 33;
  public static final int CALL_URBI = 34;
  public static final int REPORT = 35;
  public static final int ACCESSED = 36;
  public static final int RTP = 37;
  public static final int FENCE = 38;
  public static final int RTP_OFFER = 39;
  public static final int RTP_ACTIVE = 40;
  public static final int ARGUMENT_ERROR = 41;
  public static final int MODULE = 42;

  // From the kernel.
  public static final int NEW = 64;
  public static final int GONE = 65;
  public static final int CALL = 66;
  public static final int CHANGED = 67;
  public static final int ACCESS = 68;
  public static final int REPLY = 69;
  public static final int REFUSAL = 70;
  public static final int OUTPUT = 71;
  public static final int RTP_LOADED = 72;
  public static final int RTP_TERMS = 73;
  public static final int RTP_REFUSED = 74;
  public static final int RTP_MODE = 75;
  public static final int TIME = 76;
}
