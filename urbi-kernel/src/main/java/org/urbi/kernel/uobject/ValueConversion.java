package org.urbi.kernel.uobject;

import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.Steps;
import org.urbi.kernel.node.DictionaryKey;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.Elements;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiBinary;
import org.urbi.kernel.object.UrbiDictionary;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;
import org.urbi.kernel.object.UrbiTuple;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.object.Values;
import org.urbi.kernel.object.World;
import org.urbi.kernel.variable.UrbiUVar;
import urbi.UBinary;
import urbi.UDataType;
import urbi.UDictionary;
import urbi.UList;
import urbi.UValue;

/** Converts urbiscript values to {@link UValue}s and back (manual, "Binding functions"). */
final class ValueConversion {
  /** The name by which components return no object. */
  private static final String NOTHING = "nil";

  private static final int DEEPEST = 200;

  private final PluggedContext context;
  private final KernelCrossing crossing;
  private final World world;
  private final Values values;
  private final Structures structures;
  private final Symbol serializer;

  ValueConversion(PluggedContext context) {
    this.context = context;
    this.crossing = context.crossing();
    this.world = context.interpreter().world();
    this.values = world.values();
    this.structures = new Structures(context, this);
    this.serializer = world.symbol("uvalueSerialize");
  }

  // ------------------------------------------------------------------ to Java

  /**
   * Converts a value to Java; void and nil become an empty value. A container that is in many
   * others becomes as many: that may take longer than anybody waits, and more memory than there is.
   */
  UValue toJava(UrbiObject object) {
    return toJava(object, 0);
  }

  UValue toJava(UrbiObject object, int depth) {
    if (object instanceof UrbiFloat number) {
      return new UValue(number.value());
    }
    if (object instanceof UrbiString string) {
      return new UValue(Utf8Text.toComponent(string.value()));
    }
    if (object == values.trueObject || object == values.falseObject) {
      return new UValue(object == values.trueObject);
    }
    if (object == values.voidObject || object == values.nil || object == values.acceptedVoid) {
      return new UValue();
    }
    if (depth > DEEPEST) {
      throw new ConversionFailure(object, "UValue", Problem.NESTED_TOO_DEEPLY.text());
    }
    return switch (object) {
      case UrbiList list -> new UValue(list(list.elements(), depth));
      case UrbiTuple tuple -> new UValue(list(tuple.elements(), depth));
      case UrbiDictionary dictionary -> new UValue(dictionary(dictionary, depth));
      case UrbiBinary binary -> new UValue(toJava(binary));
      case UrbiUVar variable -> UValue.slotName(context.variables().handOut(variable));
      default -> other(object, depth);
    };
  }

  private UList list(List<UrbiObject> elements, int depth) {
    UList list = new UList();
    for (UrbiObject element : elements) {
      worked(element);
      list.add(toJava(element, depth + 1));
    }
    return list;
  }

  private UDictionary dictionary(UrbiDictionary dictionary, int depth) {
    UDictionary result = new UDictionary();
    dictionary
        .entries()
        .forEach((key, value) -> {
          worked(value);
          if (!(key.value() instanceof UrbiString name)) {
            throw badKey(key.value());
          }
          result.put(Utf8Text.toComponent(name.value()), toJava(value, depth + 1));
        });
    return result;
  }

  /** One more value is converted. */
  private void worked(UrbiObject value) {
    int characters = value instanceof UrbiString string ? string.value().length() : 0;
    context.interpreter().worked(Steps.OBJECT + Steps.ofCharacters(characters));
  }

  private KernelRefusal badKey(UrbiObject key) {
    return crossing.fromKernel(frame -> {
      Interpreter interpreter = frame.interpreter();
      UrbiObject type = key.lookup(interpreter.world().symbol("type"));
      String shown = Utf8Text.toJava(interpreter.asString(frame, key));
      return type == null
          ? new KernelRefusal(Problem.KEY_NOT_STRING, shown)
          : new KernelRefusal(
              Problem.KEY_OF_TYPE, shown, Utf8Text.toJava(interpreter.asString(frame, type)));
    });
  }

  private static UBinary toJava(UrbiBinary binary) {
    return new UBinary(
        Utf8Text.toComponent(binary.keywords()),
        binary.data().getBytes(StandardCharsets.ISO_8859_1));
  }

  private UValue other(UrbiObject object, int depth) {
    String name = context.objects().nameOf(object);
    if (name != null) {
      return UValue.slotName(name);
    }
    UrbiObject substitute = substitute(object);
    if (substitute != object) {
      return toJava(substitute, depth + 1);
    }
    if (structures.isStructure(object)) {
      return new UValue(structures.toJava(object, depth));
    }
    return crossing.fromKernel(frame -> {
      try {
        return new UValue(Utf8Text.toComponent(frame.interpreter().asString(frame, object)));
      } catch (UrbiException e) {
        throw new ConversionFailure(object, "UValue", null);
      }
    });
  }

  /** What travels in place of an object: itself, unless it defines {@code uvalueSerialize}. */
  private UrbiObject substitute(UrbiObject object) {
    UrbiObject holder = object.locate(serializer);
    if (holder == null || holder == world.prototype("Object")) {
      return object;
    }
    return crossing.fromKernel(frame -> frame.interpreter().send(frame, object, serializer.name()));
  }

  // ------------------------------------------------------------------ to urbiscript

  /** Converts a value from Java; an empty value becomes void. */
  UrbiObject toUrbi(@Nullable UValue value) {
    return value == null || value.isVoid() ? values.voidObject : content(value);
  }

  private UrbiObject content(UValue value) {
    return switch (value.getType()) {
      case DATA_VOID -> values.nil;
      case DATA_DOUBLE -> values.number(value.doubleValue());
      case DATA_STRING -> values.string(Utf8Text.fromComponent(value.stringValue()));
      case DATA_SLOTNAME -> named(value.stringValue());
      case DATA_LIST -> list(value.ulistValue());
      case DATA_DICTIONARY -> dictionary(value.udictionaryValue());
      case DATA_BINARY -> toUrbi(value.ubinaryValue());
    };
  }

  private UrbiObject named(String name) {
    if (name.equals(NOTHING)) {
      return values.nil;
    }
    UrbiObject object = context.objects().find(name);
    if (object != null) {
      return object;
    }
    return crossing.fromKernel(frame -> context.variables().find(frame, name));
  }

  private UrbiObject list(UList list) {
    Elements elements = new Elements(list.size());
    for (UValue element : list) {
      elements.add(content(element));
    }
    return values.listOf(elements);
  }

  private UrbiObject dictionary(UDictionary dictionary) {
    UValue structure = dictionary.get(Structures.NAME);
    if (structure != null && structure.getType() == UDataType.DATA_STRING) {
      return structures.toUrbi(structure.stringValue(), dictionary);
    }
    return crossing.fromKernel(frame -> values.dictionary(entries(frame, dictionary)));
  }

  private Map<UrbiDictionary.Key, UrbiObject> entries(Frame frame, UDictionary dictionary) {
    Map<UrbiDictionary.Key, UrbiObject> entries = new LinkedHashMap<>();
    dictionary.forEach((name, value) ->
        entries.put(
            DictionaryKey.of(frame, values.string(Utf8Text.fromComponent(name))), content(value)));
    return entries;
  }

  private UrbiObject toUrbi(UBinary binary) {
    return new UrbiBinary(
        world.prototype("Binary").cloneShape(),
        Utf8Text.fromComponent(binary.getMessage()),
        new String(binary.getData(), StandardCharsets.ISO_8859_1));
  }

  /** Converts an element of a list: an empty value becomes nil. */
  UrbiObject element(UValue value) {
    return content(value);
  }
}
