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
import org.urbi.kernel.remote.AnswerReading;
import org.urbi.kernel.remote.RemotePeer;
import org.urbi.kernel.remote.RemoteWire;
import org.urbi.kernel.remote.SilentWire;
import org.urbi.kernel.trust.Role;

/** Who is connected to a kernel: clients, and processes that bring UObjects. */
final class Connections {
  private final Kernel kernel;
  private final Operator operator;
  private final AnswerReading answers;

  /** Makes the clients of a recording that is run again. */
  private final IntFunction<Client> replayed;

  private final Set<KernelConnection> open = new LinkedHashSet<>();

  /** Those of which the kernel thread has not been told yet, by their numbers. */
  private final Map<Integer, KernelConnection> arriving = new ConcurrentHashMap<>();

  private final Map<Integer, RemotePeer> arrivingPeers = new ConcurrentHashMap<>();

  Connections(
      Kernel kernel, Operator operator, AnswerReading answers, IntFunction<Client> replayed) {
    this.kernel = kernel;
    this.operator = operator;
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
                Budget.fitting(Outside.memory(), client.budget())));
    return connection;
  }

  /** Lets a process bring UObjects. */
  RemotePeer connectRemote(String name, RemoteWire wire) {
    int number = kernel.inbox().reserve();
    RemotePeer peer = peer(number, name, wire);
    arrivingPeers.put(number, peer);
    kernel.inbox().post(new Message.RemoteOpened(number, name));
    return peer;
  }

  private RemotePeer peer(int number, String name, RemoteWire wire) {
    return new RemotePeer(
        number,
        name,
        kernel.scheduler(),
        kernel.uobjects(),
        failure -> ErrorText.describe(kernel.interpreter(), failure),
        answers,
        wire);
  }

  // ------------------------------------------------------------------ on the kernel thread

  /** A client has arrived, now or in the run that is run again. */
  void open(Message.ConnectionOpened opened) {
    int number = opened.connection();
    KernelConnection connection = arriving.remove(number);
    if (connection == null) {
      connection = new KernelConnection(kernel, number, replayed.apply(number), opened.holdsTime());
    }
    connection.open(opened.address(), Role.valueOf(opened.role()), opened.budget());
  }

  /** A process has arrived. */
  void open(Message.RemoteOpened opened) {
    RemotePeer peer = arrivingPeers.remove(opened.peer());
    (peer == null ? peer(opened.peer(), opened.name(), new SilentWire()) : peer).open();
  }

  void add(KernelConnection connection) {
    open.add(connection);
    operator.add(connection);
  }

  void remove(KernelConnection connection) {
    open.remove(connection);
    operator.remove(connection);
  }

  /** Those of clients that are open, oldest first. */
  List<KernelConnection> all() {
    return List.copyOf(open);
  }

  /** Whether one of them may bring something new. */
  boolean areAwaited() {
    for (KernelConnection connection : open) {
      if (connection.isAwaited()) {
        return true;
      }
    }
    return false;
  }

  /** What a message has brought about is our mistake, and no reason for the kernel to end. */
  void failed(Message message, Throwable failure) {
    FailureLog.internal("a message, " + message.getClass().getSimpleName(), failure);
    for (KernelConnection connection : all()) {
      if (connection.number() == message.to()) {
        connection.tell(FailureLog.text(failure));
      }
    }
  }

  /** Ends them with the kernel. */
  void finish() {
    all().forEach(KernelConnection::finish);
  }
}
