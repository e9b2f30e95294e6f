package org.urbi.kernel.tier;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.KnownSlot;
import org.urbi.kernel.node.Literals;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.SlotLookup;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;

/** Where slots have been found until now. */
final class KnownPlaces {
  /** For more shapes of targets the cache of the node is as good. */
  private static final int MOST_PLACES = 4;

  private final Unit unit;

  KnownPlaces(Unit unit) {
    this.unit = unit;
  }

  /** Where the slots of a name are that was looked up in a target. */
  List<KnownSlot> of(SlotLookup lookup, @Nullable Node target) {
    List<KnownSlot> places = new ArrayList<>();
    if (isLobby(target)) {
      KnownSlot place = ofLobby(lookup.name());
      if (place != null) {
        places.add(place);
      }
      return places;
    }
    for (SlotLookup.Known known : lookup.known()) {
      if (places.size() < MOST_PLACES) {
        places.add(known(lookup.name(), known));
      }
    }
    return places;
  }

  /** Whether the target is a lobby: its shape changes with each variable of the top level. */
  boolean isLobby(@Nullable Node target) {
    return (target == null || target instanceof Literals.This)
        && unit.frame().self() == unit.frame().job().lobby();
  }

  /** Where a slot of the lobby is; null if it is not there, or read in a special way. */
  @Nullable KnownSlot ofLobby(Symbol name) {
    UrbiObject lobby = unit.frame().self();
    UrbiObject holder = lobby.locate(name);
    if (holder == null || holder.shape().readSpecial(holder.shape().indexOf(name))) {
      return null;
    }
    lobby.announceChanges();
    lobby.world().remember(name);
    int index = holder.shape().indexOf(name);
    return new KnownSlot(lobby.world(), name, name.epoch(), null, lobby, holder, index, null);
  }

  /** A slot of targets of a shape themselves, that is to be set. */
  KnownSlot own(Symbol name, Shape shape, int index) {
    return known(name, new SlotLookup.Known(shape, null, index, null));
  }

  /** A place that is the same until the epoch of the name changes. */
  private KnownSlot known(Symbol name, SlotLookup.Known known) {
    return new KnownSlot(
        unit.frame().self().world(),
        name,
        name.epoch(),
        known.shape(),
        null,
        known.holder(),
        known.index(),
        known.own());
  }
}
