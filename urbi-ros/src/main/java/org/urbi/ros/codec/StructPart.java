package org.urbi.ros.codec;

import java.util.Arrays;
import java.util.List;
import java.util.Set;
import org.urbi.ros.message.ValueException;
import org.urbi.ros.message.Values;
import urbi.UDataType;
import urbi.UDictionary;
import urbi.UValue;

/** A message: its fields by their names. */
final class StructPart implements Part {
  private final String type;
  private final String[] names;
  private final Part[] parts;
  private final int filler;
  private final int least;

  /**
   * @param type its name, for people
   * @param filler how many bytes are sent where there is no field
   */
  StructPart(String type, List<String> names, List<Part> parts, int filler) {
    this.type = type;
    this.names = names.toArray(String[]::new);
    this.parts = parts.toArray(Part[]::new);
    this.filler = filler;
    this.least = filler + parts.stream().mapToInt(Part::least).sum();
  }

  @Override
  public void write(Output out, UValue value) {
    if (value.getType() != UDataType.DATA_DICTIONARY) {
      throw new ValueException("a Dictionary (" + type + ") expected, not " + Values.shown(value));
    }
    write(out, value.udictionaryValue());
  }

  void write(Output out, UDictionary message) {
    for (int i = 0; i < names.length; i++) {
      UValue field = message.get(names[i]);
      if (field == null) {
        throw new ValueException("this key of " + type + " is missing").within(names[i]);
      }
      try {
        parts[i].write(out, field);
      } catch (ValueException e) {
        throw e.within(names[i]);
      }
    }
    if (message.size() != names.length) {
      throw unknown(message.keySet());
    }
    for (int i = 0; i < filler; i++) {
      out.room(1).put((byte) 0);
    }
  }

  private ValueException unknown(Set<String> keys) {
    List<String> known = Arrays.asList(names);
    String first = keys.stream().filter(key -> !known.contains(key)).findFirst().orElseThrow();
    return new ValueException(type + " has no such key; it has " + known).within(first);
  }

  @Override
  public UValue read(Input in) {
    return new UValue(readMessage(in));
  }

  UDictionary readMessage(Input in) {
    UDictionary message = new UDictionary();
    for (int i = 0; i < names.length; i++) {
      message.put(names[i], parts[i].read(in));
    }
    if (filler > 0) {
      in.bytes(filler);
    }
    return message;
  }

  @Override
  public int least() {
    return least;
  }
}
