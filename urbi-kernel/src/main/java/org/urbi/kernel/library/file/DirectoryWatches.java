package org.urbi.kernel.library.file;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.JobOwner;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.outside.DirectoryWatch;
import org.urbi.kernel.outside.Outside;

/**
 * The directories that code watches. A lobby is told once of each file, however many of its events
 * are of that directory, and in one job, for which it answers; what nobody listens to any more is
 * watched no longer.
 */
final class DirectoryWatches {
  private static final int FEW = 64;

  private final Outside outside;
  private final Map<UrbiObject, Map<Path, Watch>> watches = new IdentityHashMap<>();

  /** How many events have been added since those that nobody listens to were looked for. */
  private int added;

  private int mostAdded = FEW;

  DirectoryWatches(Outside outside) {
    this.outside = outside;
  }

  /** What a lobby watches of one directory. */
  private final class Watch implements DirectoryWatch.Listener {
    final Interpreter interpreter;
    final UrbiObject lobby;
    final Path directory;
    final int number = outside.watcher(this);
    final List<DirectoryEvents> listeners = new ArrayList<>();

    Watch(Interpreter interpreter, UrbiObject lobby, Path directory) {
      this.interpreter = interpreter;
      this.lobby = lobby;
      this.directory = directory;
    }

    @Override
    public void created(String name) {
      tell(name, true);
    }

    @Override
    public void deleted(String name) {
      tell(name, false);
    }

    private void tell(String name, boolean created) {
      if (isOver()) {
        end(this);
        return;
      }
      List<DirectoryEvents> told = List.copyOf(listeners);
      JobOwner.start(
          interpreter.scheduler(),
          lobby,
          "directory",
          job -> told.forEach(events -> events.emit(job, created, name)));
    }

    boolean isOver() {
      listeners.removeIf(events -> !events.listensTo(directory));
      return listeners.isEmpty();
    }
  }

  /**
   * Has events of a lobby tell of the files of a directory from now on.
   *
   * @throws IOException when there is no such directory, or the machine watches no more of them
   */
  void add(
      Interpreter interpreter, Job job, UrbiObject lobby, Path directory, DirectoryEvents events)
      throws IOException {
    if (++added > mostAdded) {
      endUnused();
    }
    Watch watch =
        watches
            .computeIfAbsent(lobby, any -> new LinkedHashMap<>())
            .computeIfAbsent(directory, any -> new Watch(interpreter, lobby, directory));
    watch.listeners.add(events);
    try {
      outside.watch(job, directory, watch.number);
    } catch (IOException e) {
      watch.listeners.remove(events);
      if (watch.listeners.isEmpty()) {
        end(watch);
      }
      throw e;
    }
  }

  /** Now and then, the rarer the more there is to look at. */
  private void endUnused() {
    List<Watch> all = watches.values().stream().flatMap(each -> each.values().stream()).toList();
    int left = 0;
    for (Watch watch : all) {
      if (watch.isOver()) {
        end(watch);
      }
      left += watch.listeners.size();
    }
    added = 0;
    mostAdded = left + FEW;
  }

  private void end(Watch watch) {
    Map<Path, Watch> ofLobby = watches.get(watch.lobby);
    if (ofLobby != null && ofLobby.remove(watch.directory, watch) && ofLobby.isEmpty()) {
      watches.remove(watch.lobby);
    }
    outside.endWatch(watch.number);
  }
}
