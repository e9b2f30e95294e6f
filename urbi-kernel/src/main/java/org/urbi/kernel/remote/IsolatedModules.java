package org.urbi.kernel.remote;

import java.io.Closeable;
import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Future;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.budget.Resource;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.lobby.Diagnostics;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.outside.Outside;
import org.urbi.kernel.uobject.ModuleIsolation;
import org.urbi.kernel.uobject.PluggedContext;
import urbi.UModuleException;

/** The modules that run in processes of their own: what such a process does, costs its objects. */
public final class IsolatedModules implements ModuleIsolation {
  private final PluggedContext context;
  private final Outside outside;
  private final Function<String, RemotePeer> peers;

  /** Null where the program around the kernel makes no processes. */
  private final @Nullable ModuleProcesses processes;

  /**
   * @param peers makes the kernel's side of a process, of its name
   */
  public IsolatedModules(
      PluggedContext context,
      Outside outside,
      Function<String, RemotePeer> peers,
      @Nullable ModuleProcesses processes) {
    this.context = context;
    this.outside = outside;
    this.peers = peers;
    this.processes = processes;
  }

  @Override
  public IsolatedModule start(Frame frame, Path file) {
    if (processes == null && !outside.scheduler().journal().isReplay()) {
      throw new UModuleException(Problem.NO_ISOLATION.text());
    }
    frame.job().identity().take(Resource.PROCESSES);
    Isolated module = new Isolated(frame, file);
    module.start();
    return module;
  }

  /** One of them. */
  private final class Isolated implements IsolatedModule, Supervisor {
    private final Budget budget;
    private final UrbiObject loader;
    private final RemotePeer peer;

    /** Null in a replay. */
    private final @Nullable ModuleProcess process;

    private final Closeable closing = () -> kill(Problem.KERNEL_ENDED.text());
    private final CompletableFuture<@Nullable Void> started = new CompletableFuture<>();
    private boolean unwanted;
    private boolean ended;

    Isolated(Frame frame, Path file) {
      budget = frame.job().budget();
      loader = frame.job().lobby();
      peer = peers.apply(String.valueOf(file.getFileName()));
      peer.superviseBy(this);
      process = processes == null ? null : processes.process(file, peer);
    }

    private void kill(String why) {
      if (process != null) {
        process.kill(why);
      }
    }

    void start() {
      outside.opened(closing);
      if (process != null) {
        outside.start(process::start);
      }
    }

    @Override
    public void awaitStart() {
      try {
        context.await(started);
        if (started.isCompletedExceptionally()) {
          throw new UModuleException(String.valueOf(started.exceptionNow().getMessage()));
        }
      } finally {
        // A job that is stopped while it waits has no use for the process.
        if (started.state() != Future.State.SUCCESS) {
          unwanted = true;
          kill(Problem.MODULE_UNLOADED.text());
        }
      }
    }

    @Override
    public boolean isRunning() {
      return !ended && !unwanted;
    }

    @Override
    public void end() {
      unwanted = true;
      kill(Problem.MODULE_UNLOADED.text());
      peer.end(Problem.MODULE_UNLOADED.text());
    }

    @Override
    public boolean isMissed() {
      return started.isDone() && isRunning();
    }

    @Override
    public void disconnected(String why) {
      if (process != null) {
        process.disconnected(why);
      }
    }

    @Override
    public void told(String problem) {
      if (!problem.isEmpty()) {
        started.completeExceptionally(new UModuleException(problem));
        kill(problem);
      } else if (started.complete(null) && process != null) {
        process.started();
      }
    }

    @Override
    public void ended(String why) {
      boolean missed = isMissed();
      ended = true;
      outside.closed(closing);
      budget.giveBack(Resource.PROCESSES);
      started.completeExceptionally(new UModuleException(why));
      if (missed) {
        why.lines().forEach(this::tell);
      }
    }

    /** Tells the log, and who has loaded it. */
    private void tell(String line) {
      context.report(line);
      if (loader instanceof UrbiLobby lobby && lobby.isInstance() && lobby.isConnected()) {
        Diagnostics.error(lobby.output(), Utf8Text.toUrbi(line));
      }
    }
  }
}
