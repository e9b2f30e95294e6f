package org.urbi.kernel.library.code;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Wait;
import org.urbi.lang.source.Span;

/** Which source files one kernel has loaded, or is loading (manual, "System": requireFile). */
public final class LoadedFiles {
  /** A file that is being loaded: the loading job, and the jobs that wait for it. */
  private static final class Loading {
    final Job loader;
    final List<Job> waiting = new ArrayList<>();

    Loading(Job loader) {
      this.loader = loader;
    }
  }

  private final Set<Path> loaded = new HashSet<>();
  private final Set<String> systemFiles = new HashSet<>();
  private final Map<Path, Loading> underWay = new LinkedHashMap<>();

  /** A file of the library has been loaded; messages call it so. */
  public void noteSystemFile(String name) {
    systemFiles.add(name);
  }

  /** The prefix of library files in messages. */
  public List<String> systemFiles() {
    return systemFiles.stream().sorted().toList();
  }

  /** From now on, these are the files of the library. */
  public void setSystemFiles(List<String> names) {
    systemFiles.clear();
    systemFiles.addAll(names);
  }

  /** Whether a place is in a file of the library. */
  public boolean isOfSystem(Span place) {
    return systemFiles.contains(place.location().file());
  }

  /** A file is being loaded from now on; tell its {@link #end}. */
  public void begin(Job job, Path file) {
    underWay.putIfAbsent(file, new Loading(job));
  }

  /**
   * A file has been loaded.
   *
   * @param complete whether that went well
   */
  public void end(Job job, Path file, boolean complete) {
    if (complete) {
      loaded.add(file);
    }
    Loading loading = underWay.get(file);
    if (loading != null && loading.loader == job) {
      underWay.remove(file);
      loading.waiting.forEach(Job::wake);
    }
  }

  /** Whether a file has been loaded; when it is being loaded, the job waits until it has. */
  public boolean contains(Job job, Path file) {
    Loading loading = underWay.get(file);
    // A file that requires itself must not wait for its own end.
    while (loading != null && !waitsFor(loading.loader, job)) {
      loading.waiting.add(job);
      try {
        job.waitForWake(Wait.FILE);
      } finally {
        loading.waiting.remove(job);
      }
      loading = underWay.get(file);
    }
    return loading != null || loaded.contains(file);
  }

  /** Whether a job waits, perhaps through others, for files which that job is loading. */
  private boolean waitsFor(Job job, Job loader) {
    if (job == loader) {
      return true;
    }
    for (Loading loading : underWay.values()) {
      if (loading.waiting.contains(job) && waitsFor(loading.loader, loader)) {
        return true;
      }
    }
    return false;
  }
}
