package org.urbi.kernel.library.file;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.event.UrbiEvent;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;

/**
 * The events {@code fileCreated} and {@code fileDeleted} of one directory (manual, "Directory").
 * The directory is watched from the first subscription to one of them.
 */
final class DirectoryEvents {
  private final Interpreter interpreter;
  private final DirectoryWatches watches;
  private final UrbiObject lobby;
  private final UrbiDirectory directory;
  private final UrbiEvent created;
  private final UrbiEvent deleted;
  private @Nullable Path watched;

  private DirectoryEvents(Frame frame, DirectoryWatches watches, UrbiDirectory directory) {
    this.interpreter = frame.interpreter();
    this.watches = watches;
    this.lobby = frame.job().lobby();
    this.directory = directory;
    this.created = event("fileCreated");
    this.deleted = event("fileDeleted");
  }

  /** Gives a directory its events. */
  static void add(Frame frame, DirectoryWatches watches, UrbiDirectory directory) {
    new DirectoryEvents(frame, watches, directory);
  }

  private UrbiEvent event(String name) {
    UrbiEvent event = (UrbiEvent) interpreter.prototypes().event.cloned();
    event.setOnSubscribe(this::watch);
    Symbol symbol = interpreter.world().symbol(name);
    directory.removeSlot(symbol);
    directory.addSlot(symbol, event);
    return event;
  }

  private void watch() {
    Path file = directory.file();
    if (file.equals(watched)) {
      return;
    }
    boolean first = watched == null;
    watched = file;
    Scheduler scheduler = interpreter.scheduler();
    Job job = requireNonNull(scheduler.running(), "who subscribes is code");
    try {
      watches.add(interpreter, job, lobby, file, this);
    } catch (IOException e) {
      watched = null;
      throw interpreter
          .errors()
          .primitive("fileCreated", Problem.CANNOT_WATCH, FileAccess.reason(e));
    }
    if (first) {
      scheduler.pace().beginWhile(this::hasSubscribers);
    }
  }

  private boolean hasSubscribers() {
    return created.hasSubscribers() || deleted.hasSubscribers();
  }

  /** Whether anybody listens to what happens there; if not, whoever subscribes begins anew. */
  boolean listensTo(Path file) {
    if (!file.equals(watched)) {
      return false;
    }
    if (!hasSubscribers()) {
      watched = null;
    }
    return watched != null;
  }

  /** Tells of a file that has been created or deleted, in that job. */
  void emit(Job job, boolean isNew, String name) {
    UrbiEvent event = isNew ? created : deleted;
    if (event.hasSubscribers()) {
      event.emit(job, false, interpreter.values().string(Utf8Text.toUrbi(name)));
    }
  }
}
