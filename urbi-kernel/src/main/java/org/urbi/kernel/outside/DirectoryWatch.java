package org.urbi.kernel.outside;

import java.io.Closeable;
import java.io.IOException;
import java.nio.file.ClosedWatchServiceException;
import java.nio.file.FileSystems;
import java.nio.file.Path;
import java.nio.file.StandardWatchEventKinds;
import java.nio.file.WatchEvent;
import java.nio.file.WatchKey;
import java.nio.file.WatchService;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.urbi.kernel.log.FailureLog;
import org.urbi.kernel.message.Message;

/** Notices the files that are created in directories and deleted from them. */
public final class DirectoryWatch implements Closeable {
  /** Called on the kernel thread for what happens in a directory. */
  public interface Listener {
    void created(String name);

    void deleted(String name);

    /** Passes on the event of a message. */
    default void take(Message message) {
      switch (message) {
        case Message.FileCreated file -> created(file.name());
        case Message.FileDeleted file -> deleted(file.name());
        default -> throw new IllegalArgumentException(message.toString());
      }
    }
  }

  private static final class Watched {
    final Path directory;
    final Set<Integer> listeners = new LinkedHashSet<>();
    final Set<String> known;

    Watched(Path directory) throws IOException {
      this.directory = directory;
      this.known = names(directory);
    }
  }

  private final Outside outside;
  private final WatchService service;
  private final Map<WatchKey, Watched> watched = new LinkedHashMap<>();
  private final Queue<Integer> forgotten = new ConcurrentLinkedQueue<>();

  DirectoryWatch(Outside outside) throws IOException {
    this.outside = outside;
    service = FileSystems.getDefault().newWatchService();
    outside.opened(this);
    outside.start(this::listen);
  }

  /**
   * Watches a directory from now on; from any thread but the kernel's.
   *
   * @param listener the number of the receiver of the messages
   * @throws IOException when there is no such directory, or the system cannot watch more
   */
  void watch(Path directory, int listener) throws IOException {
    synchronized (watched) {
      forgetForgotten();
      WatchKey key =
          directory.register(
              service, StandardWatchEventKinds.ENTRY_CREATE, StandardWatchEventKinds.ENTRY_DELETE);
      Watched known = watched.get(key);
      if (known == null) {
        known = new Watched(directory);
        watched.put(key, known);
      }
      known.listeners.add(listener);
    }
  }

  /** Tells that receiver no more. */
  void forget(int listener) {
    forgotten.add(listener);
  }

  /** The lock may be held for as long as a disk takes, for which the kernel does not wait. */
  private void forgetForgotten() {
    Set<Integer> gone = new HashSet<>();
    for (Integer next = forgotten.poll(); next != null; next = forgotten.poll()) {
      gone.add(next);
    }
    if (!gone.isEmpty()) {
      watched.forEach((key, at) -> {
        if (at.listeners.removeAll(gone) && at.listeners.isEmpty()) {
          key.cancel();
        }
      });
      watched.values().removeIf(at -> at.listeners.isEmpty());
    }
  }

  private void listen() {
    try {
      while (true) {
        WatchKey key = service.take();
        List<WatchEvent<?>> events = key.pollEvents();
        try {
          tell(key, events);
        } catch (RuntimeException | Error e) {
          FailureLog.internal("watching a directory", e);
        }
        if (!key.reset()) {
          synchronized (watched) {
            watched.remove(key);
          }
        }
      }
    } catch (ClosedWatchServiceException e) {
      // The kernel has ended.
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void tell(WatchKey key, List<WatchEvent<?>> events) {
    synchronized (watched) {
      forgetForgotten();
      Watched at = watched.get(key);
      if (at == null) {
        return;
      }
      for (WatchEvent<?> event : events) {
        if (event.kind() == StandardWatchEventKinds.OVERFLOW) {
          compare(at);
        } else {
          String name = event.context().toString();
          boolean created = event.kind() == StandardWatchEventKinds.ENTRY_CREATE;
          tell(at, name, created);
        }
      }
    }
  }

  private static Set<String> names(Path directory) throws IOException {
    Set<String> names = new TreeSet<>();
    DirectoryTree.names(directory, Integer.MAX_VALUE).forEach(name -> names.add(name.toString()));
    return names;
  }

  /**
   * Events were lost because there were too many: compares the directory with its last known
   * content.
   */
  private void compare(Watched at) {
    Set<String> now;
    try {
      now = names(at.directory);
    } catch (IOException e) {
      now = Set.of();
    }
    for (String name : new TreeSet<>(at.known)) {
      if (!now.contains(name)) {
        tell(at, name, false);
      }
    }
    for (String name : now) {
      if (!at.known.contains(name)) {
        tell(at, name, true);
      }
    }
  }

  private void tell(Watched at, String name, boolean created) {
    if (created) {
      at.known.add(name);
    } else {
      at.known.remove(name);
    }
    for (int listener : at.listeners) {
      outside
          .inbox()
          .post(
              created
                  ? new Message.FileCreated(listener, name)
                  : new Message.FileDeleted(listener, name));
    }
  }

  @Override
  public void close() throws IOException {
    service.close();
  }
}
