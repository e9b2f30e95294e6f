package org.urbi.sim.world;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.urbi.sim.world.WorldFileException.Place;
import org.urbi.sim.world.WorldFileTokens.Kind;
import org.urbi.sim.world.WorldFileTokens.Token;

/**
 * {@code kind name { property values; … block … }} of a world file. Properties are asked for by
 * type; whoever has asked for all that it knows calls {@link #finish}, which refuses the rest.
 */
final class Block {
  private record Property(Place place, List<Token> values) {}

  private final String kind;
  private final @Nullable String name;
  private final Place place;
  private final Map<String, Property> properties = new LinkedHashMap<>();
  private final List<Block> blocks = new ArrayList<>();

  /** All that has been asked for, for suggestions. */
  private final Set<String> known = new TreeSet<>();

  Block(String kind, @Nullable String name, Place place) {
    this.kind = kind;
    this.name = name;
    this.place = place;
  }

  void addProperty(String property, Place at, List<Token> values) {
    if (properties.putIfAbsent(property, new Property(at, values)) != null) {
      throw new WorldFileException(at, property + " is given twice");
    }
  }

  void addBlock(Block block) {
    blocks.add(block);
  }

  String kind() {
    return kind;
  }

  Place place() {
    return place;
  }

  List<Block> blocks() {
    return blocks;
  }

  /** Its name, which it must have. */
  String name() {
    if (name == null) {
      throw new WorldFileException(place, kind + " has no name");
    }
    return name;
  }

  /** Its name, or null. */
  @Nullable String optionalName() {
    return name;
  }

  void requireNoName() {
    if (name != null) {
      throw new WorldFileException(place, kind + " takes no name, but has '" + name + "'");
    }
  }

  WorldFileException wrong(String message) {
    return new WorldFileException(place, kind + (name == null ? "" : " " + name) + ": " + message);
  }

  WorldFileException wrong(String property, String message) {
    Property p = properties.get(property);
    return p == null
        ? wrong(property + ": " + message)
        : new WorldFileException(p.place(), property + ": " + message);
  }

  boolean has(String property) {
    known.add(property);
    return properties.containsKey(property);
  }

  private @Nullable Property property(String name) {
    known.add(name);
    return properties.get(name);
  }

  /** So many numbers, or null. */
  double @Nullable [] numbers(String property, int count, Unit unit) {
    Property found = property(property);
    if (found == null) {
      return null;
    }
    List<Token> values = found.values();
    double factor = 1;
    int given = values.size();
    if (given > 0 && values.getLast().kind() == Kind.WORD) {
      Token last = values.getLast();
      given--;
      Double named = unit.factor(last.text());
      if (named == null) {
        throw new WorldFileException(
            last.place(),
            unit == Unit.NONE
                ? property + " takes no unit, but has " + last.shown()
                : property + ": unknown unit " + last.shown() + "; it is in " + unit.names());
      }
      factor = named;
    }
    if (given != count) {
      throw wrong(
          property, count + (count == 1 ? " number" : " numbers") + " expected, not " + given);
    }
    double[] numbers = new double[count];
    for (int i = 0; i < count; i++) {
      Token value = values.get(i);
      if (value.kind() != Kind.NUMBER || !Double.isFinite(value.number())) {
        throw new WorldFileException(
            value.place(), property + ": number expected, not " + value.shown());
      }
      numbers[i] = value.number() * factor;
    }
    return numbers;
  }

  double number(String property, Unit unit, double otherwise) {
    double[] numbers = numbers(property, 1, unit);
    return numbers == null ? otherwise : numbers[0];
  }

  double requiredNumber(String property, Unit unit) {
    return required(property, numbers(property, 1, unit))[0];
  }

  double[] requiredNumbers(String property, int count, Unit unit) {
    return required(property, numbers(property, count, unit));
  }

  private <T> T required(String property, @Nullable T value) {
    if (value == null) {
      throw wrong(property + " is missing");
    }
    return value;
  }

  /** A whole number. */
  int integer(String property, int otherwise) {
    double number = number(property, Unit.NONE, otherwise);
    if (number != Math.rint(number) || Math.abs(number) > Integer.MAX_VALUE) {
      throw wrong(property, "whole number expected, not " + number);
    }
    return (int) number;
  }

  /** The words of a property, or null. */
  @Nullable List<String> words(String property, int count) {
    Property given = property(property);
    if (given == null) {
      return null;
    }
    List<Token> values = given.values();
    if (values.size() != count) {
      throw wrong(
          property, count + (count == 1 ? " name" : " names") + " expected, not " + values.size());
    }
    for (Token value : values) {
      if (value.kind() != Kind.WORD && value.kind() != Kind.STRING) {
        throw new WorldFileException(
            value.place(), property + ": name expected, not " + value.shown());
      }
    }
    return values.stream().map(Token::text).toList();
  }

  @Nullable String word(String property) {
    List<String> words = words(property, 1);
    return words == null ? null : words.getFirst();
  }

  String requiredWord(String property) {
    return required(property, word(property));
  }

  /** Refuses the properties that nobody has asked for. */
  void finish() {
    for (Map.Entry<String, Property> property : properties.entrySet()) {
      if (!known.contains(property.getKey())) {
        throw new WorldFileException(
            property.getValue().place(),
            "a "
                + kind
                + " has no "
                + property.getKey()
                + (known.isEmpty() ? "" : "; it has " + String.join(", ", known)));
      }
    }
  }

  /** Refuses blocks inside, for kinds that have none. */
  void requireNoBlocks() {
    if (!blocks.isEmpty()) {
      throw new WorldFileException(
          blocks.getFirst().place, "a " + kind + " contains no " + blocks.getFirst().kind);
    }
  }
}
