package org.urbi.kernel.lobby;

import java.util.List;
import java.util.NoSuchElementException;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.builtin.Primitive;
import org.urbi.kernel.node.Code;
import org.urbi.kernel.object.SlotData;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Values;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.input.TypedText;
import org.urbi.lang.parse.ParseResult;
import org.urbi.lang.parse.UrbiParser;

/**
 * What an expression that somebody is typing will give: the object itself where it can be read
 * without running anything, the prototype of the result where the library declares it.
 */
final class ExpectedValue {
  /** How many local variables may be declared with one another. */
  private static final int DEEPEST = 16;

  /**
   * A longer expression was not typed, in characters: what is nested deeper takes so long to parse
   * that those who ask again and again would hold the kernel.
   */
  private static final int LONGEST = 1 << 10;

  private final UrbiObject lobby;
  private final Values values;
  private final TypedText typed;
  private int depth;

  ExpectedValue(UrbiObject lobby, TypedText typed) {
    this.lobby = lobby;
    this.values = lobby.world().values();
    this.typed = typed;
  }

  /** What has the slots of the value of an expression; null when nobody can tell. */
  @Nullable UrbiObject of(String expression) {
    if (expression.isEmpty() || expression.length() > LONGEST || depth == DEEPEST) {
      return null;
    }
    ParseResult parsed = UrbiParser.parse(expression, null);
    if (!parsed.valid() || parsed.sequence().statements().size() != 1) {
      return null;
    }
    depth++;
    UrbiObject value = of(parsed.sequence().statements().getFirst());
    depth--;
    return value;
  }

  private @Nullable UrbiObject of(Ast expression) {
    return switch (expression) {
      case Ast.FloatLiteral number -> values.floatProto;
      case Ast.StringLiteral string -> values.stringProto;
      case Ast.ListLiteral list -> values.listProto;
      case Ast.TupleLiteral tuple -> values.tupleProto;
      case Ast.DictionaryLiteral dictionary -> values.dictionaryProto;
      case Ast.Function function -> lobby.world().prototype("Code");
      case Ast.This self -> lobby;
      case Ast.Message message -> message(message);
      case Ast.SlotAccess access -> access(access);
      default -> null;
    };
  }

  private @Nullable UrbiObject access(Ast.SlotAccess access) {
    UrbiObject owner = access.target() == null ? lobby : of(access.target());
    return owner == null ? null : owner.lookup(owner.world().symbol(access.name()));
  }

  private @Nullable UrbiObject message(Ast.Message message) {
    Ast target = message.target();
    String name = message.name();
    if (target == null) {
      return typed.locals().contains(name)
          ? of(typed.valueOf(name))
          : slot(lobby, name, message.arguments());
    }
    UrbiObject owner = of(target);
    if (owner == null || name.equals("new")) {
      return owner;
    }
    return name.equals("[]")
        ? element(owner, message.arguments())
        : slot(owner, name, message.arguments());
  }

  private static @Nullable UrbiObject slot(
      UrbiObject owner, String name, @Nullable List<Ast> arguments) {
    Symbol symbol = owner.world().symbol(name);
    UrbiObject value = owner.lookup(symbol);
    if (value instanceof Primitive primitive) {
      return prototype(owner, primitive.result());
    }
    return value instanceof Code || arguments != null || isComputed(owner, symbol) ? null : value;
  }

  /** Whether a function is called for the value. */
  private static boolean isComputed(UrbiObject object, Symbol slot) {
    UrbiObject owner = object.locate(slot);
    SlotData data = owner == null ? null : owner.slotData(slot);
    return data != null && data.getter() != null;
  }

  private static @Nullable UrbiObject element(UrbiObject owner, @Nullable List<Ast> index) {
    if (owner instanceof UrbiList list
        && index != null
        && index.size() == 1
        && index.getFirst() instanceof Ast.FloatLiteral number
        && number.value() >= 0
        && number.value() < list.elements().size()) {
      return list.elements().get((int) number.value());
    }
    return null;
  }

  /** The prototype of a type of the library; null when it is none. */
  private static @Nullable UrbiObject prototype(UrbiObject asked, String type) {
    try {
      return type.isEmpty() || type.equals("void") ? null : asked.world().prototype(type);
    } catch (NoSuchElementException e) {
      return null;
    }
  }
}
