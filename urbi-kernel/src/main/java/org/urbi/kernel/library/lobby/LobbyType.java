package org.urbi.kernel.library.lobby;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Optional;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.budget.Resource;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.lobby.Lobbies;
import org.urbi.kernel.lobby.Output;
import org.urbi.kernel.lobby.Shell;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.PermissionCheck;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/** The environment of a connection (manual, "Lobby"). */
@UrbiType(
    value = "Lobby",
    protos = {"Channel.topLevel"},
    doc = "The environment of a connection.",
    needs = Permission.NOTHING)
public final class LobbyType {
  private final Lobbies lobbies;

  LobbyType(Lobbies lobbies) {
    this.lobbies = lobbies;
  }

  /** The lobby for which code runs. */
  public static UrbiLobby of(Frame frame) {
    return (UrbiLobby) frame.job().lobby();
  }

  /** Where code sends something to its own client; there must be room for it. */
  public static Output output(Frame frame) {
    return output(frame, of(frame));
  }

  /** Where code sends something in the name of an object; its own lobby must have room for it. */
  public static Output output(Frame frame, UrbiObject self) {
    UrbiLobby own = of(frame);
    UrbiLobby to = self instanceof UrbiLobby lobby && lobby.isInstance() ? lobby : own;
    if (to == own && to.output().isFull()) {
      throw frame.job().identity().refusal(Resource.OUTPUT);
    }
    return to.output();
  }

  /** The output for a message; nobody may send to a lobby in the name of another one. */
  static Output output(Frame frame, String routine, UrbiObject self) {
    if (self instanceof UrbiLobby lobby && lobby.isInstance()) {
      PermissionCheck.checkChange(frame, routine, lobby);
    }
    return output(frame, self);
  }

  @Builtin(doc = "Sends a value as text after a prefix, '*** ', on a channel if one is given.")
  static void echo(
      Frame frame,
      UrbiObject self,
      UrbiObject value,
      @Optional @Nullable String channel,
      @Optional @Nullable String prefix) {
    String text = frame.interpreter().asString(frame, value);
    output(frame, "echo", self)
        .send(channel == null ? "" : channel, (prefix == null ? "*** " : prefix) + text);
  }

  @Builtin(doc = "Sends each member of a list as text, on a channel if one is given.")
  static void echoEach(
      Frame frame, UrbiObject self, UrbiList list, @Optional @Nullable String channel) {
    for (UrbiObject value : list.elements()) {
      echo(frame, self, value, channel, null);
    }
  }

  @Builtin(doc = "Sends text with a time stamp, on a channel if one is given.")
  static void send(Frame frame, UrbiObject self, String text, @Optional @Nullable String channel) {
    output(frame, "send", self).send(channel == null ? "" : channel, text);
  }

  @Builtin(doc = "Sends bytes as they are.")
  static void write(Frame frame, UrbiObject self, String bytes) {
    output(frame, "write", self).write(bytes);
  }

  @Builtin(doc = "The lobby for which this code runs.")
  static UrbiObject lobby(Frame frame, UrbiObject self) {
    return of(frame);
  }

  @Builtin(doc = "The lobby of code that belongs to no connection, such as what UObjects send.")
  UrbiObject systemLobby(Frame frame, UrbiObject self) {
    return lobbies.system();
  }

  @Builtin(doc = "Whether somebody is at the other end.")
  static boolean connected(Frame frame, UrbiObject self) {
    return own(frame, self).isConnected();
  }

  @Builtin(doc = "The tag of all the code that runs for this lobby.")
  static UrbiObject connectionTag(Frame frame, UrbiObject self) {
    return own(frame, self).connectionTag();
  }

  @Builtin(doc = "How many bytes have been sent to the client.")
  static double bytesSent(Frame frame, UrbiObject self) {
    return own(frame, self).output().bytesSent();
  }

  @Builtin(
      doc =
          "How much this lobby may have at a time of jobs, timers, processes, output, input, time,"
              + " hold, or depth.")
  static double budget(Frame frame, CallSite site, UrbiObject self, String what) {
    long limit = own(frame, self).budget().limit(resource(frame, site, what));
    return limit == Budget.UNLIMITED ? Double.POSITIVE_INFINITY : limit;
  }

  @Builtin(doc = "How many jobs, timers, or processes this lobby has.")
  static double budgetUsed(Frame frame, CallSite site, UrbiObject self, String what) {
    return own(frame, self).budget().used(resource(frame, site, what));
  }

  @Builtin(doc = "Sets how much of that this lobby may have at a time.", needs = Permission.OWNER)
  static void setBudget(Frame frame, CallSite site, UrbiObject self, String what, double most) {
    Resource resource = resource(frame, site, what);
    if (!(most >= 0)) {
      throw frame.error(site, Problem.NEGATIVE_BUDGET);
    }
    own(frame, self).budget().setLimit(resource, (long) most);
  }

  private static Resource resource(Frame frame, CallSite site, String word) {
    try {
      return Resource.of(word);
    } catch (IllegalArgumentException e) {
      throw frame.error(site, Problem.NO_SUCH_BUDGET, word);
    }
  }

  @Builtin(doc = "Closes the connection.")
  static void quit(Frame frame, UrbiObject self) {
    UrbiLobby lobby = self instanceof UrbiLobby own && own.hasShell() ? own : of(frame);
    PermissionCheck.checkChange(frame, "quit", lobby);
    if (lobby.hasShell()) {
      lobby.shell().close();
    } else {
      lobby
          .connectionTag()
          .state()
          .stop(frame.job().scheduler(), frame.interpreter().values().voidObject);
    }
    frame.job().checkInjected();
  }

  @Builtin(
      value = {"clone", "new"},
      doc = "Not possible: lobbies are created.")
  static UrbiObject clone(Frame frame, CallSite site, UrbiObject self) {
    throw frame.error(site, Problem.LOBBY_NOT_CLONEABLE);
  }

  @Builtin(doc = "A fresh lobby, whose output goes to this connection.", needs = Permission.USER)
  UrbiObject create(Frame frame, UrbiObject self) {
    return lobbies.create(of(frame));
  }

  /** The prototype of lobbies, and the existing lobbies. */
  public static List<UrbiObject> instances(World world, Lobbies lobbies) {
    List<UrbiObject> all = new ArrayList<>();
    all.add(world.prototype("Lobby"));
    all.addAll(lobbies.all());
    return all;
  }

  @Builtin(doc = "The lobbies that are alive, the prototype of lobbies included.")
  public List<UrbiObject> instances(Frame frame, UrbiObject self) {
    return instances(self.world(), lobbies);
  }

  @Builtin(doc = "How many bytes have come from the client.")
  static double bytesReceived(Frame frame, UrbiObject self) {
    Shell shell = own(frame, self).shell();
    return shell == null ? 0 : shell.bytesReceived();
  }

  @Builtin(doc = "Executes text as if the client had sent it.")
  static void receive(Frame frame, UrbiObject self, String value) {
    UrbiLobby lobby = own(frame, self);
    PermissionCheck.checkChange(frame, "receive", lobby);
    Shell shell = lobby.shell();
    if (shell != null) {
      shell.receive(value);
    }
  }

  @Builtin(
      doc = "Has the lobby begin as those of new connections do: with local.u, if there is one.")
  static void initialize(Frame frame, UrbiObject self, @Optional @Nullable UrbiObject remote) {
    receive(frame, self, "maybeLoad(\"local.u\");");
  }

  @Builtin(
      doc = "Sends a value as text to all lobbies, on a channel if one is given.",
      needs = Permission.USER)
  void wall(Frame frame, UrbiObject self, UrbiObject value, @Optional @Nullable String channel) {
    new GlobalOutput(lobbies).wall(frame, self, value, channel);
  }

  @Builtin(doc = "The Internet address of the client; empty when there is none.")
  static String remoteIP(Frame frame, UrbiObject self) {
    return own(frame, self).remoteAddress();
  }

  /** The target; for the prototype, the lobby for which code runs. */
  static UrbiLobby own(Frame frame, UrbiObject self) {
    return self instanceof UrbiLobby lobby && lobby.isInstance() ? lobby : of(frame);
  }

  /** The prototype, which is no connection itself. */
  static UrbiObject newPrototype(World world) {
    return new UrbiLobby(world.values().object.cloneShape(), null);
  }
}
