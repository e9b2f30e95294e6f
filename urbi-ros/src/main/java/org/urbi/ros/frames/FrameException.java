package org.urbi.ros.frames;

import org.urbi.ros.graph.RosException;

/** Nobody can say where a frame is; the message says what is missing. */
public final class FrameException extends RosException {
  FrameException(String message) {
    super(message);
  }
}
