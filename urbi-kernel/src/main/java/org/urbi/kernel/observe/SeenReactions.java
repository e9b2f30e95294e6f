package org.urbi.kernel.observe;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.WeakHashMap;
import org.urbi.kernel.event.Reaction;
import org.urbi.kernel.event.UrbiEvent;
import org.urbi.kernel.lobby.UrbiLobby;

/** The reactions and events that somebody has been told of. On the kernel thread. */
final class SeenReactions {
  /** How many of each are shown. */
  private static final int MOST = 500;

  /** How many names of what a condition has read are shown. */
  private static final int MOST_READ = 8;

  private final KnownEvents known;
  private final SeenTags tags;
  private final Map<Reaction, Long> numbers = new WeakHashMap<>();
  private final Told<Long, ReactionRow> rows = new Told<>();
  private final Told<Long, EventRow> events = new Told<>();
  private long last;

  SeenReactions(KnownEvents known, SeenTags tags) {
    this.known = known;
    this.tags = tags;
  }

  /**
   * Looks at them again.
   *
   * @param text only what contains it is wanted, in whatever case
   */
  ReactionView look(String text) {
    String wanted = text.toLowerCase(Locale.ROOT);
    List<Reaction> all = known.reactions();
    List<Reaction> matching = new ArrayList<>();
    for (Reaction each : all) {
      if (contains(wanted, text(each.facts()))) {
        matching.add(each);
      }
    }
    for (Reaction each : matching.subList(0, Math.min(MOST, matching.size()))) {
      long number = numbers.computeIfAbsent(each, unknown -> ++last);
      rows.is(number, row(number, each));
    }
    int eventTotal = 0;
    for (Map.Entry<UrbiEvent, String> each : known.events(all).entrySet()) {
      if (contains(wanted, each.getValue()) && ++eventTotal <= MOST) {
        UrbiEvent event = each.getKey();
        events.is(event.number(), row(event, each.getValue()));
      }
    }
    return new ReactionView(
        matching.size(), rows.changes(), rows.gone(), eventTotal, events.changes(), events.gone());
  }

  private static boolean contains(String wanted, String text) {
    return wanted.isEmpty() || text.toLowerCase(Locale.ROOT).contains(wanted);
  }

  private static String text(Reaction.Facts facts) {
    return facts.kind() + " " + Written.beginning(facts.span());
  }

  private ReactionRow row(long number, Reaction reaction) {
    Reaction.Facts facts = reaction.facts();
    UrbiEvent event = facts.event();
    return new ReactionRow(
        number,
        facts.kind(),
        facts.lobby() instanceof UrbiLobby lobby ? lobby.name() : "",
        Written.place(facts.span()),
        Written.beginning(facts.span()),
        facts.scope().isFrozen(),
        tags.of(facts.scope()),
        facts.occurrences().times(),
        facts.occurrences().last(),
        event == null ? 0 : event.number(),
        reaction.read(MOST_READ));
  }

  private static EventRow row(UrbiEvent event, String name) {
    return new EventRow(
        event.number(),
        name,
        event.subscriberCount(),
        event.emissions().times(),
        event.emissions().last());
  }
}
