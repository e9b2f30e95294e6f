package org.urbi.kernel;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.IntFunction;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.log.FailureLog;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.outside.Outside;
import org.urbi.kernel.remote.AnswerPoller;
import org.urbi.kernel.remote.RemotePeer;
import org.urbi.kernel.remote.RemoteTransport;
import org.urbi.kernel.remote.UnconnectedTransport;

/** Who is connected to a kernel: clients, and processes that bring UObjects. */
final class Connections {
  private final Kernel kernel;
  private final OutOfBandControl outOfBand;
  private final AnswerPoller answers;

  /** Creates the clients of a replayed run. */
  private final IntFunction<Client> replayed;

  private final Set<KernelConnection> open = new LinkedHashSet<>();

  /** Connections that the kernel thread does not know of yet, by number. */
  private final Map<Integer, KernelConnection> arriving = new ConcurrentHashMap<>();

  private final Map<Integer, RemotePeer> arrivingPeers = new ConcurrentHashMap<>();

  Connections(
      Kernel kernel,
      OutOfBandControl outOfBand,
      AnswerPoller answers,
      IntFunction<Client> replayed) {
    this.kernel = kernel;
    this.outOfBand = outOfBand;
    this.answers = answers;
    this.replayed = replayed;
  }

  // ------------------------------------------------------------------ from any thread

  /** Opens a connection. */
  Connection connect(Client client, boolean holdsTime) {
    int number = kernel.inbox().reserve();
    KernelConnection connection = new KernelConnection(kernel, number, client, holdsTime);
    arriving.put(number, connection);
    kernel
        .inbox()
        .post(
            new Message.ConnectionOpened(
                number,
                holdsTime,
                client.remoteAddress(),
                client.role().name(),
                Budget.fitting(Outside.memory(), client.budget()),
                client.errors().name(),
                client.isProgram(),
                client.isAwaited()));
    return connection;
  }

  /** Lets a process bring UObjects. */
  RemotePeer connectRemote(String name, RemoteTransport wire) {
    int number = kernel.inbox().reserve();
    RemotePeer peer = peer(number, name, wire);
    arrivingPeers.put(number, peer);
    kernel.inbox().post(new Message.RemoteOpened(number, name, wire.console()));
    return peer;
  }

  /** The kernel's side of a process that is about to be started; on the kernel thread. */
  RemotePeer expectRemote(String name) {
    int number = kernel.inbox().register(message -> {});
    RemotePeer peer = peer(number, name, new UnconnectedTransport());
    peer.open();
    return peer;
  }

  private RemotePeer peer(int number, String name, RemoteTransport wire) {
    return new RemotePeer(
        number,
        name,
        kernel.scheduler(),
        kernel.uobjects(),
        failure -> ErrorText.ofRequest(kernel.interpreter(), failure),
        answers,
        wire);
  }

  // ------------------------------------------------------------------ on the kernel thread

  /** A client has connected, now or in the run that is replayed. */
  void open(Message.ConnectionOpened opened) {
    int number = opened.connection();
    KernelConnection connection = arriving.remove(number);
    if (connection == null) {
      connection = new KernelConnection(kernel, number, replayed.apply(number), opened.holdsTime());
    }
    try {
      connection.open(opened);
    } catch (OutOfMemoryError e) {
      // Its client must not wait for a lobby that it never gets.
      connection.finish();
      kernel.inbox().forget(number);
      throw e;
    }
  }

  /** A remote process has connected. */
  void open(Message.RemoteOpened opened) {
    RemotePeer peer = arrivingPeers.remove(opened.peer());
    if (peer == null) {
      peer = peer(opened.peer(), opened.name(), new UnconnectedTransport());
    }
    peer.open();
    for (KernelConnection connection : open) {
      if (connection.number() == opened.console()) {
        peer.belongTo(connection.lobby());
      }
    }
  }

  void add(KernelConnection connection) {
    open.add(connection);
    outOfBand.add(connection);
    kernel.memory().add(connection);
    open.forEach(KernelConnection::lobbyOpened);
  }

  void remove(KernelConnection connection) {
    open.remove(connection);
    outOfBand.remove(connection);
    kernel.memory().remove(connection);
  }

  /** The open connections of clients, oldest first. */
  List<KernelConnection> all() {
    return List.copyOf(open);
  }

  /** Whether one of the clients may still send input. */
  boolean areAwaited() {
    for (KernelConnection connection : open) {
      if (connection.isAwaited()) {
        return true;
      }
    }
    return false;
  }

  /** A message that cannot be handled is a bug of ours, but no reason to end the kernel. */
  void failed(Message message, Throwable failure) {
    FailureLog.internal("a message, " + message.getClass().getSimpleName(), failure);
    for (KernelConnection connection : all()) {
      if (connection.number() == message.to()) {
        connection.tell(FailureLog.text(failure));
      }
    }
  }

  /** The kernel is about to end, perhaps with the process: tells those who have asked for it. */
  void lookLast() {
    for (KernelConnection connection : all()) {
      try {
        connection.lookLast();
      } catch (RuntimeException | Error e) {
        FailureLog.internal("the last look at the jobs", e);
      }
    }
  }

  /** Closes all connections when the kernel ends. */
  void finish() {
    all().forEach(KernelConnection::finish);
  }
}
