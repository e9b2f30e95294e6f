package org.urbi.kernel.observe;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.WeakHashMap;
import org.urbi.kernel.event.Reaction;
import org.urbi.kernel.event.UrbiEvent;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.lang.source.Span;

/** The reactions and events that somebody has been told of. On the kernel thread. */
final class SeenReactions {
  /** How many of each are shown. */
  private static final int MOST = 500;

  /** How many names of what a condition has read are shown. */
  private static final int MOST_READ = 8;

  /** What never changes of a reaction. */
  private record Lasting(long number, String place, String code) {}

  private final KnownEvents known;
  private final SeenTags tags;
  private final Map<Reaction, Lasting> lasting = new WeakHashMap<>();
  private final SentRows<Long, ReactionRow> rows = new SentRows<>();
  private final SentRows<Long, EventRow> events = new SentRows<>();
  private long last;
  private boolean told;

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
      if (contains(wanted, wanted.isEmpty() ? "" : text(each))) {
        matching.add(each);
      }
    }
    for (Reaction each : matching.subList(0, Math.min(MOST, matching.size()))) {
      ReactionRow row = row(each);
      rows.is(row.number(), row);
    }
    int eventTotal = 0;
    for (Map.Entry<UrbiEvent, String> each : known.events(all).entrySet()) {
      if (contains(wanted, each.getValue()) && ++eventTotal <= MOST) {
        UrbiEvent event = each.getKey();
        events.is(event.number(), row(event, each.getValue()));
      }
    }
    boolean anew = !told;
    told = true;
    return new ReactionView(
        anew,
        matching.size(),
        rows.changes(),
        rows.gone(),
        eventTotal,
        events.changes(),
        events.gone());
  }

  private static boolean contains(String wanted, String text) {
    return wanted.isEmpty() || text.toLowerCase(Locale.ROOT).contains(wanted);
  }

  private String text(Reaction reaction) {
    return reaction.facts().kind() + " " + lasting(reaction).code();
  }

  private Lasting lasting(Reaction reaction) {
    return lasting.computeIfAbsent(
        reaction,
        unknown -> {
          Span span = reaction.facts().span();
          return new Lasting(++last, Written.place(span), Written.beginning(span));
        });
  }

  private ReactionRow row(Reaction reaction) {
    Reaction.Facts facts = reaction.facts();
    UrbiEvent event = facts.event();
    Lasting known = lasting(reaction);
    return new ReactionRow(
        known.number(),
        facts.kind(),
        facts.lobby() instanceof UrbiLobby lobby ? lobby.name() : "",
        known.place(),
        known.code(),
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
