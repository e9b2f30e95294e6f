package org.urbi.kernel.remote;

import java.nio.ByteBuffer;
import org.jspecify.annotations.Nullable;
import urbi.rtp.RtpParameters;
import urbi.rtp.RtpSession;

/**
 * The transport of a process that is not connected: in a replay, where it is only a recording, or
 * because it has only just been started.
 */
public final class UnconnectedTransport implements RemoteTransport {
  @Override
  public void send(byte[] frames) {}

  @Override
  public void close(String reason) {}

  @Override
  public void openDatagrams(RtpParameters terms) {}

  @Override
  public @Nullable RtpSession datagrams() {
    return null;
  }

  @Override
  public void closeDatagrams() {}

  @Override
  public void consumed(int bytes) {}

  @Override
  public void wantToRead() {}

  @Override
  public boolean read(ByteBuffer space) {
    return false;
  }

  @Override
  public void stopReading() {}

  @Override
  public void attended() {}
}
