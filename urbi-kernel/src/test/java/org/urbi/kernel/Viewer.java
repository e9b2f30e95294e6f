package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.NoSuchElementException;
import java.util.TreeMap;
import java.util.function.Predicate;
import org.urbi.kernel.observe.EventRow;
import org.urbi.kernel.observe.JobRow;
import org.urbi.kernel.observe.ObjectView;
import org.urbi.kernel.observe.ReactionRow;
import org.urbi.kernel.observe.SlotRow;
import org.urbi.kernel.observe.Steering.Action;
import org.urbi.kernel.observe.TagRow;
import org.urbi.kernel.observe.View;
import org.urbi.kernel.observe.ViewRequest;
import org.urbi.kernel.trust.Role;

/** One who looks at a kernel: puts together what has been told, and intervenes. */
public final class Viewer {
  final TestClient client;
  final Map<Long, JobRow> jobs = new TreeMap<>();
  final Map<Long, TagRow> tags = new TreeMap<>();
  public final Map<Long, ReactionRow> reactions = new TreeMap<>();
  public final Map<Long, EventRow> events = new TreeMap<>();

  /** The slots of the object that was looked at last. */
  final Map<String, SlotRow> slots = new TreeMap<>();

  /** What was told last. */
  View last;

  /** What was told last of an object. */
  ObjectView object;

  /** How many jobs have changed in the last round. */
  int changes;

  /** How many views that round had, and how many of them told nothing. */
  int views;

  int voidViews;

  private String way = "";

  public Viewer(Kernel kernel, Role role) {
    client = new TestClient(kernel, role);
  }

  // ------------------------------------------------------------------ looks

  /** A round over all jobs. */
  Viewer look(ViewRequest wanted) {
    changes = 0;
    views = 0;
    voidViews = 0;
    do {
      last = client.connection().look(wanted).join();
      views++;
      voidViews += last.isVoid() ? 1 : 0;
      assertTrue(last.jobs().size() <= 200, "a limited number in one tick");
      take();
    } while (!last.complete());
    return this;
  }

  private void take() {
    last.jobs().forEach(row -> jobs.put(row.number(), row));
    last.gone().forEach(jobs::remove);
    last.tags().forEach(row -> tags.put(row.number(), row));
    last.tagsGone().forEach(tags::remove);
    changes += last.jobs().size() + last.gone().size();
    if (last.reactions() != null) {
      last.reactions().gone().forEach(reactions::remove);
      last.reactions().reactions().forEach(row -> reactions.put(row.number(), row));
      last.reactions().eventsGone().forEach(events::remove);
      last.reactions().events().forEach(row -> events.put(row.number(), row));
    }
    if (last.variables() != null) {
      for (ObjectView each : last.variables().objects()) {
        object = each;
        each.gone().forEach(slots::remove);
        each.slots().forEach(row -> slots.put(row.name(), row));
      }
    }
  }

  Viewer look() {
    return look(new ViewRequest(0, List.of(), null, null));
  }

  /**
   * Looks at the reactions and events.
   *
   * @param text which they contain; null to look away
   */
  public Viewer lookFor(String text) {
    return look(new ViewRequest(0, List.of(), text, null));
  }

  /** Looks at one object. */
  Viewer lookAt(String at) {
    if (!at.equals(way)) {
      slots.clear();
      way = at;
    }
    return look(new ViewRequest(0, List.of(), null, List.of(at)));
  }

  // ------------------------------------------------------------------ what it sees

  JobRow await(Predicate<JobRow> wanted) {
    while (true) {
      for (JobRow row : look().jobs.values()) {
        if (wanted.test(row)) {
          return row;
        }
      }
    }
  }

  TagRow tag(String name) {
    return only(look().tags, row -> row.name().equals(name), name);
  }

  JobRow under(String tag) {
    long number = tag(tag).number();
    return await(row -> row.tags().contains(number));
  }

  ReactionRow reaction(String code) {
    return only(lookFor("").reactions, row -> row.code().startsWith(code), code);
  }

  EventRow event(String name) {
    return only(lookFor("").events, row -> row.name().equals(name), name);
  }

  SlotRow slot(String at, String name) {
    return only(lookAt(at).slots, row -> row.name().equals(name), name);
  }

  private static <K, R> R only(Map<K, R> rows, Predicate<R> wanted, String what) {
    return rows.values().stream()
        .filter(wanted)
        .findFirst()
        .orElseThrow(() -> new NoSuchElementException(what + " is not among " + rows));
  }

  // ------------------------------------------------------------------ what it does

  String steer(Action action, boolean tag, long target) {
    return client.connection().steer(action, tag, target).join();
  }

  String emit(String name, String payload) {
    return client.connection().emit(event(name).number(), payload).join();
  }

  String assign(String at, String value) {
    return client.connection().assign(at, value).join();
  }
}
