package org.urbi.kernel.remote;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.KernelPoller;
import org.urbi.kernel.outside.SocketSelector;

/**
 * Reads the answers of remote processes on the kernel thread while it has nothing to do but to wait
 * for them: waking a network thread first, which then wakes the kernel, would double the time of a
 * call. The frames are posted to the inbox, as the network thread does. This is only done by a
 * kernel that makes one call after another; and not if something is due within a millisecond,
 * because the deadlines of a selector are no finer. When the kernel waits for no answer, the
 * network thread reads again.
 */
public final class AnswerPoller implements KernelPoller {
  /** After this many waits in a row for nothing but an answer, the kernel thread reads itself. */
  private static final int OFTEN = 16;

  private static final long MILLISECOND = 1_000_000;

  /** How long a busy kernel goes without polling for answers, in nanoseconds. */
  private static final long LONG = 200_000;

  private final List<RemotePeer> asked = new ArrayList<>();
  private final List<RemotePeer> read = new ArrayList<>();
  private final List<RemotePeer> ready = new ArrayList<>();
  private @Nullable ByteBuffer space;
  private @Nullable SocketSelector<RemotePeer> watch;
  private int waits;
  private boolean looking;
  private long looked;

  /** A request was sent to a process. */
  void asked(RemotePeer peer) {
    if (!asked.contains(peer)) {
      asked.add(peer);
    }
  }

  /** A process has disconnected. */
  void forget(RemotePeer peer) {
    asked.remove(peer);
    if (read.remove(peer)) {
      pollSockets();
    }
  }

  @Override
  public @Nullable Wait begin(long nanoseconds) {
    for (int i = asked.size() - 1; i >= 0; i--) {
      if (!asked.get(i).isAsked()) {
        asked.remove(i);
      }
    }
    if (asked.isEmpty() || nanoseconds < MILLISECOND) {
      waits = 0;
      leave();
      return null;
    }
    if (++waits < OFTEN && read.isEmpty()) {
      return null;
    }
    asked.forEach(RemotePeer::wantToRead);
    if (read.isEmpty()) {
      return null;
    }
    watch().limit(nanoseconds / MILLISECOND);
    return watch();
  }

  @Override
  public void poll() {
    looking = true;
    pass();
  }

  /** The network thread has handed a connection over to the kernel thread. */
  void begin(RemotePeer peer) {
    SocketSelector.Socket socket = peer.socket();
    if (socket == null) {
      return;
    }
    try {
      if (watch == null) {
        watch = new SocketSelector<>();
        space = ByteBuffer.allocateDirect(1 << 16);
      }
      watch.add(socket, peer);
      read.add(peer);
    } catch (IOException e) {
      // The connection is closed, or about to be.
      peer.stopReading();
    }
  }

  private SocketSelector<RemotePeer> watch() {
    return requireNonNull(watch, "made before the first connection is read");
  }

  private ByteBuffer space() {
    return requireNonNull(space, "made together with the watch");
  }

  private void unwatch(RemotePeer peer) {
    SocketSelector.Socket socket = peer.socket();
    if (socket != null) {
      watch().remove(socket);
    }
  }

  private void leave() {
    for (int i = read.size() - 1; i >= 0; i--) {
      RemotePeer peer = read.remove(i);
      unwatch(peer);
      peer.stopReading();
    }
  }

  private void pollSockets() {
    watch().pollNow();
    pass();
  }

  /** Posts the frames that have arrived. */
  private void pass() {
    watch().ready(ready);
    for (int i = ready.size() - 1; i >= 0; i--) {
      RemotePeer peer = ready.remove(i);
      if (!peer.read(space())) {
        read.remove(peer);
        unwatch(peer);
      }
    }
  }

  @Override
  public void pollIfDue(long now) {
    if (looking) {
      looking = false;
      looked = now;
    } else if (!read.isEmpty() && now - looked > LONG) {
      looked = now;
      pollSockets();
    }
  }

  @Override
  public void close() {
    leave();
    try {
      if (watch != null) {
        watch.close();
      }
    } catch (IOException e) {
      // The selector is no longer usable.
    }
  }
}
