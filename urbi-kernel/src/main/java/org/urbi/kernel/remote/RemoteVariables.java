package org.urbi.kernel.remote;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.uobject.PluggedContext;
import urbi.UValue;
import urbi.rtp.RtpMode;

/** The variables that a remote process uses, by the numbers that both sides use; in its job. */
final class RemoteVariables {
  private final RemotePeer peer;
  private final Map<Integer, RemoteVariable> variables = new HashMap<>();

  /** How many uses of a variable the process has ended by name. */
  private final Map<String, Double> unnotified = new HashMap<>();

  RemoteVariables(RemotePeer peer) {
    this.peer = peer;
  }

  /** Opens a variable under a number. */
  UValue open(int id, boolean port, String name) {
    PluggedContext context = peer.context();
    RemoteVariable variable =
        new RemoteVariable(peer, id, port ? context.inputPort(name) : context.variable(name));
    variables.put(id, variable);
    if (variable.rtp() != RtpMode.RTP_DEFAULT) {
      peer.datagrams().tellMode(variable);
    }
    variable.watch(1);
    return port ? new UValue() : variable.slot().get();
  }

  /** Closes a variable that the process no longer uses. */
  void close(int id) {
    get(id).close();
    variables.remove(id);
    peer.datagrams().close(id);
  }

  /** The variable of that number. */
  RemoteVariable get(int id) {
    RemoteVariable variable = variables.get(id);
    if (variable == null) {
      throw new IllegalArgumentException(Problem.NO_VARIABLE.text(id));
    }
    return variable;
  }

  /** The process ends so many uses of a variable. */
  void unnotify(String name, double times) {
    List<RemoteVariable> named =
        variables.values().stream().filter(each -> each.slot().name().equals(name)).toList();
    double ended = unnotified.merge(name, times, Double::sum);
    if (ended >= named.stream().mapToInt(RemoteVariable::uses).sum()) {
      unnotified.remove(name);
      named.forEach(RemoteVariable::unwatch);
    }
  }

  /** Sends the values that were held back. */
  void refresh() {
    variables.values().forEach(RemoteVariable::refresh);
  }

  /** The process has ended. */
  void end() {
    variables.values().forEach(RemoteVariable::close);
    variables.clear();
  }
}
