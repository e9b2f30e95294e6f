package org.urbi.kernel.library.file;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.event.UrbiEvent;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.JobOwner;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.outside.DirectoryWatch;
import org.urbi.kernel.outside.Outside;

/**
 * The events {@code fileCreated} and {@code fileDeleted} of one directory (manual, "Directory").
 * The directory is watched from the first subscription to one of them.
 */
final class DirectoryEvents implements DirectoryWatch.Listener {
  private final Interpreter interpreter;
  private final Outside outside;
  private final UrbiObject lobby;
  private final UrbiDirectory directory;
  private final UrbiEvent created;
  private final UrbiEvent deleted;
  private @Nullable Path watched;

  private DirectoryEvents(Frame frame, Outside outside, UrbiDirectory directory) {
    this.interpreter = frame.interpreter();
    this.outside = outside;
    this.lobby = frame.job().lobby();
    this.directory = directory;
    this.created = event("fileCreated");
    this.deleted = event("fileDeleted");
  }

  /** Gives a directory its events. */
  static void add(Frame frame, Outside outside, UrbiDirectory directory) {
    new DirectoryEvents(frame, outside, directory);
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
      outside.watch(job, file, this);
    } catch (IOException e) {
      watched = null;
      throw interpreter
          .errors()
          .primitive("fileCreated", Problem.CANNOT_WATCH, FileAccess.reason(e));
    }
    if (first) {
      scheduler.pace().beginWhile(() -> created.hasSubscribers() || deleted.hasSubscribers());
    }
  }

  @Override
  public void created(String name) {
    emit(created, name);
  }

  @Override
  public void deleted(String name) {
    emit(deleted, name);
  }

  private void emit(UrbiEvent event, String name) {
    if (event.hasSubscribers()) {
      UrbiObject payload = interpreter.values().string(Utf8Text.toUrbi(name));
      JobOwner.start(
          interpreter.scheduler(), lobby, "directory", job -> event.emit(job, false, payload));
    }
  }
}
