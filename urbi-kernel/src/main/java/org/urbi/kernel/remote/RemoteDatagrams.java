package org.urbi.kernel.remote;

import org.urbi.kernel.error.Problem;
import urbi.UDataType;
import urbi.UValue;
import urbi.rtp.RtpOptions;
import urbi.rtp.RtpParameters;
import urbi.rtp.RtpSession;
import urbi.wire.Frame;
import urbi.wire.WireOutput;

/**
 * The values that a remote process gets in datagrams instead of frames, if both sides want that.
 */
final class RemoteDatagrams {
  private final RemotePeer peer;

  RemoteDatagrams(RemotePeer peer) {
    this.peer = peer;
  }

  /** Tells the process whether a variable is sent in datagrams. */
  void tellMode(RemoteVariable variable) {
    if (peer.lost() == null) {
      int mode = variable.rtp().ordinal();
      peer.write(o -> o.begin(Frame.RTP_MODE).size(variable.id()).octet(mode).end());
    }
  }

  /** The process offers to exchange values in datagrams. */
  void open(RtpParameters terms) {
    if (peer.context().rtp().isOn()) {
      peer.wire().openDatagrams(terms);
    } else {
      refuse(Problem.NOT_LOADED_HERE);
    }
  }

  private void refuse(Problem why) {
    peer.write(o -> o.begin(Frame.RTP_REFUSED).text(why.text(RtpOptions.MODULE)).end());
  }

  /** The module that enables datagrams was loaded or unloaded. */
  void turned(boolean on) {
    if (peer.lost() != null) {
      return;
    }
    if (on) {
      peer.write(o -> o.begin(Frame.RTP_LOADED).end());
    } else {
      peer.wire().closeDatagrams();
      refuse(Problem.NOT_LOADED_ANY_MORE);
    }
  }

  /**
   * Sends a new value.
   *
   * @param time in microseconds
   * @return whether it has gone; otherwise it has to go in a frame, after what {@link #leave}
   *     writes
   */
  boolean send(RemoteVariable variable, UValue value, long time) {
    RtpSession session = peer.wire().datagrams();
    if (session == null || !session.isActive() || !variable.rtp().includes(value)) {
      return false;
    }
    byte[] frame =
        new WireOutput(1 << 6)
            .begin(Frame.CHANGED)
            .size(variable.id())
            .number(time)
            .value(value)
            .end()
            .inside();
    return session.send(variable.id(), value.getType() == UDataType.DATA_BINARY, frame);
  }

  /** The next value of that variable goes in a frame. */
  void leave(RemoteVariable variable, WireOutput out) {
    RtpSession session = peer.wire().datagrams();
    if (session != null) {
      session.leave(variable.id(), out, Frame.LEFT);
    }
  }

  /** The process does not use the variable of that number any more. */
  void close(int id) {
    RtpSession session = peer.wire().datagrams();
    if (session != null) {
      session.close(id);
    }
  }
}
