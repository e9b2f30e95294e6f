package urbi.rtp;

import urbi.UDataType;
import urbi.UValue;

/** Whether values of a variable travel in datagrams (manual, "Per-UVar control of RTP mode"). */
public enum RtpMode {
  /** None does. */
  RTP_NO,
  /** All do. */
  RTP_YES,
  /** Binaries do. */
  RTP_DEFAULT;

  /** Whether that value does. */
  public boolean includes(UValue value) {
    return this == RTP_YES || this == RTP_DEFAULT && value.getType() == UDataType.DATA_BINARY;
  }

  /** The mode of that number; the default if there is none. */
  public static RtpMode of(int number) {
    return number >= 0 && number < values().length ? values()[number] : RTP_DEFAULT;
  }
}
