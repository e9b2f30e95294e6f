package org.urbi.kernel.lobby;

import static java.util.Objects.requireNonNull;

import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.budget.Budgeted;
import org.urbi.kernel.event.UrbiEvent;
import org.urbi.kernel.job.EndInPieces;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.JobOwner;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.job.TagScope;
import org.urbi.kernel.job.TagState;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.tag.UrbiTag;
import org.urbi.kernel.trust.Role;
import org.urbi.kernel.trust.RoleHolder;

/** The environment of one connection (manual, "Lobby"): {@code this} at its top level. */
public final class UrbiLobby extends UrbiObject implements RoleHolder, Budgeted, JobOwner {
  private static final String NO_LOBBY = "the prototype of lobbies is no lobby";

  private final @Nullable UrbiTag connectionTag;
  private @Nullable Output output;
  private @Nullable Shell shell;
  private @Nullable RemoteObjects remoteObjects;
  private String name = "Lobby";
  private volatile String remoteAddress = "";
  private volatile Role role = Role.OWNER;
  private Budget budget = new Budget();
  private boolean connected = true;
  private final EarlierFailures failures = new EarlierFailures();

  /** Labels what its code has detached from the connection. */
  private final TagState detachedTag = TagState.ofDetached();

  private @Nullable TagScope detached;

  /** The lobbies that its code has made, and that end with it. */
  private final Set<UrbiLobby> created = new LinkedHashSet<>(0);

  /**
   * @param connectionTag labels all the code executed for this lobby; null for the prototype
   */
  public UrbiLobby(Shape shape, @Nullable UrbiTag connectionTag) {
    super(shape);
    this.connectionTag = connectionTag;
    setOwnerLobby(this);
    if (connectionTag != null) {
      connectionTag.setOwnerLobby(this);
    }
  }

  /** What has failed in it, of which people are told as a cause. */
  public EarlierFailures failures() {
    return failures;
  }

  /** The tag of all the code that is executed for this lobby. */
  public UrbiTag connectionTag() {
    return requireNonNull(connectionTag, NO_LOBBY);
  }

  /**
   * Where a job runs that is detached from the connection, and so under no tag that code can name.
   *
   * @param starter starts it; then the scope must be {@linkplain TagScope#end ended}
   */
  public TagScope detachedScope(Job starter) {
    TagScope scope = detached;
    if (scope == null || scope.isOver()) {
      scope = TagScope.branch(starter.scheduler(), detachedTag, starter.scheduler().rootScope());
      detached = scope;
    }
    return scope;
  }

  /** Whether its code has detached something from the connection that is still there. */
  public boolean hasDetached() {
    return detachedTag.isUsed();
  }

  /** Whether all jobs under the connection have ended. */
  public boolean hasEnded() {
    return connectionTag().state().isIdle();
  }

  /** Ends what is left when the client has left: what its code has detached, and what lingers. */
  public void endDetached(Interpreter interpreter) {
    for (TagState tag : List.of(connectionTag().state(), detachedTag)) {
      tag.abandon(interpreter.scheduler(), interpreter.values().voidObject);
    }
  }

  /** Ends all that it does, and what is left of it: if it was ended before, what lingers, too. */
  public void endForGood(Interpreter interpreter) {
    boolean lingers = hasLeft();
    shell().close();
    if (lingers) {
      endDetached(interpreter);
    } else {
      detachedTag.abandon(interpreter.scheduler(), interpreter.values().voidObject);
    }
  }

  /** The name of its {@link #connectionTag}, which identifies it for users. */
  public String name() {
    return name;
  }

  /** Its name, and where its client is, for people. */
  public String description() {
    return remoteAddress.isEmpty() ? name : name + " (" + remoteAddress + ")";
  }

  @Override
  public Role role() {
    return role;
  }

  @Override
  public Budget budget() {
    return budget;
  }

  @Override
  public @Nullable TagState lifeTag() {
    return connectionTag == null ? null : connectionTag.state();
  }

  @Override
  public boolean hasLeft() {
    return shell != null && shell.isClosed();
  }

  /**
   * Sets its role.
   *
   * @param jobs all running jobs
   */
  public void setRole(Role other, Collection<Job> jobs) {
    role = other;
    for (Job job : jobs) {
      if (job.lobby() == this) {
        job.identity().become(this);
      }
    }
  }

  public void attach(Output to) {
    output = to;
  }

  public void attach(Shell of) {
    shell = of;
  }

  public void attach(RemoteObjects of) {
    remoteObjects = of;
  }

  /** The UObjects that its client has declared; null if there are none. */
  public @Nullable RemoteObjects remoteObjects() {
    return remoteObjects;
  }

  /** Its output, if it is an {@linkplain #isInstance instance}. */
  public Output output() {
    return requireNonNull(output, NO_LOBBY);
  }

  /** Whether it has input of its own. */
  public boolean hasShell() {
    return shell != null;
  }

  /** Executes its input, if it {@linkplain #hasShell has any}. */
  public Shell shell() {
    return requireNonNull(shell, "a lobby of a program has no input");
  }

  /** The Internet address at the other end; empty when there is none. */
  public String remoteAddress() {
    return remoteAddress;
  }

  public void setRemoteAddress(String address) {
    remoteAddress = address;
  }

  /** Whether it is a real lobby, and not the prototype of lobbies. */
  public boolean isInstance() {
    return output != null;
  }

  /** Creates a lobby, and starts to execute its input. */
  public static UrbiLobby start(
      Interpreter interpreter, Output output, Shell.Listener listener, Role role, Budget budget) {
    UrbiObject prototype = interpreter.world().prototype("Lobby");
    long number = interpreter.scheduler().nextNumber();
    String name = "Lobby_" + number;
    UrbiLobby made = new UrbiLobby(prototype.cloneShape(), UrbiTag.named(interpreter, name));
    made.name = name;
    made.attach(output);
    made.attach(new Shell(interpreter, made, listener));
    made.role = role;
    made.budget = budget;
    return made;
  }

  /** From now on a lobby that its code has made ends with it; at once if it has ended. */
  public void addCreated(UrbiLobby lobby) {
    if (hasLeft()) {
      lobby.shell().close();
    } else {
      created.add(lobby);
    }
  }

  /** Forgets a lobby that has ended. */
  public void removeCreated(UrbiLobby lobby) {
    created.remove(lobby);
  }

  /** Ends the lobbies that are to end with it. */
  void closeCreated(Scheduler scheduler) {
    EndInPieces.begin(
        scheduler,
        created,
        lobby -> {
          lobby.shell().closeAlone();
          return lobby.created;
        });
    created.clear();
  }

  /** Whether the connection is open. A condition that asks is evaluated again when it closes. */
  public boolean isConnected() {
    noteContentRead();
    return connected && output().isOpen();
  }

  /**
   * Is no longer connected, and emits {@code Lobby.onDisconnect} for this lobby: not in a job of
   * its own, for which its budget might be exhausted.
   */
  public void disconnected(Interpreter interpreter, Lobbies lobbies) {
    connected = false;
    noteContentChange();
    UrbiObject event =
        interpreter
            .world()
            .prototype("Lobby")
            .localSlot(interpreter.world().symbol("onDisconnect"));
    if (event instanceof UrbiEvent told && told.hasSubscribers()) {
      Scheduler scheduler = interpreter.scheduler();
      // Whoever leaves may be running a job, which must not get what exhausted budgets throw.
      scheduler.atEndOfTick(() -> told.emitApart(scheduler, lobbies::system, this));
    }
  }
}
