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
 * Hears on the kernel thread what remote processes answer, while that has nothing to do but to wait
 * for it: a thread of the network's that were woken first, to wake the kernel, would double the
 * time of a call. The frames are posted to the inbox, as the network's thread does. Only a kernel
 * that makes one call after the other does so; and not when something is to be done within a
 * millisecond, since a selector's deadlines are no finer. When it waits for no answer, the
 * network's thread reads again.
 */
public final class AnswerPoller implements KernelPoller {
  /** How many times in a row there was nothing to do but to wait for an answer. */
  private static final int OFTEN = 16;

  private static final long MILLISECOND = 1_000_000;

  /** How long a busy kernel does not look whether there is an answer, in nanoseconds. */
  private static final long LONG = 200_000;

  private final List<RemotePeer> asked = new ArrayList<>();
  private final List<RemotePeer> read = new ArrayList<>();
  private final List<RemotePeer> ready = new ArrayList<>();
  private @Nullable ByteBuffer space;
  private @Nullable SocketSelector<RemotePeer> watch;
  private int waits;
  private boolean looking;
  private long looked;

  /** A process has been asked something. */
  void asked(RemotePeer peer) {
    if (!asked.contains(peer)) {
      asked.add(peer);
    }
  }

  /** A process has gone. */
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

  /** The network has left a connection to the kernel. */
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

  /** Posts what there is. */
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
      // It is of no use any more.
    }
  }
}
