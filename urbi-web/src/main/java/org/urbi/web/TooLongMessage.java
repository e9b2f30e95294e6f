package org.urbi.web;

import io.netty.handler.codec.DecoderException;

/**
 * A message on a stream is longer than its page allows; the text tells people how long one may be.
 */
public final class TooLongMessage extends DecoderException {
  private static final long serialVersionUID = 1;

  TooLongMessage(int most) {
    super("a message may have " + most + " bytes, not more");
  }
}
