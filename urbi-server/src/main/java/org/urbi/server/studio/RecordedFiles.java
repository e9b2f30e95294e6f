package org.urbi.server.studio;

import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.jspecify.annotations.Nullable;

/**
 * The files to which variables are recorded, or were, for those who look. May be used from any
 * thread.
 */
public final class RecordedFiles {
  /** Of how many it is known that they were made here. */
  static final int MOST = 16;

  /**
   * A file.
   *
   * @param number by which browsers ask for it: they cannot ask for any other file
   * @param path as whoever began it has written it
   */
  record Recording(int number, Path path) {}

  private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
  private final Deque<Recording> finished = new ArrayDeque<>();
  private int begun;
  private @Nullable Recording current;

  /** What is being written; null if nothing is. */
  synchronized @Nullable Recording current() {
    return current;
  }

  /** Those that are complete, the oldest first. */
  synchronized List<Recording> finished() {
    return List.copyOf(finished);
  }

  /** Variables are recorded to a file from now on, which is overwritten. */
  public synchronized void begin(Path file) {
    finish();
    finished.removeIf(each -> each.path.toAbsolutePath().equals(file.toAbsolutePath()));
    current = new Recording(++begun, file);
    tell();
  }

  /** Nothing is recorded any more. */
  public synchronized void end() {
    if (finish()) {
      tell();
    }
  }

  private boolean finish() {
    Recording complete = current;
    if (complete == null) {
      return false;
    }
    if (finished.size() == MOST) {
      finished.removeFirst();
    }
    finished.addLast(complete);
    current = null;
    return true;
  }

  /** Changes are told in the order in which they happen. */
  private void tell() {
    listeners.forEach(Runnable::run);
  }

  /**
   * Calls a listener at each change, on the thread on which it happens.
   *
   * @return what ends it
   */
  Runnable listen(Runnable changed) {
    listeners.add(changed);
    return () -> listeners.remove(changed);
  }
}
