package org.urbi.kernel.node;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Errors;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/**
 * {@code assert (claim)}. When the claim does not hold, the message shows it as written, and with
 * the values that it had (manual, "Assertions").
 */
public final class Assertion extends Node {
  /** What is claimed. */
  public sealed interface Claim {
    /** The claim as the message shows it. */
    String text();
  }

  /** A claim of which the message shows only the value. */
  public record PlainClaim(String text, Node code) implements Claim {}

  /**
   * A claim that is a message send, split so that the values of its parts can be shown.
   *
   * @param operator as it was written, or null
   * @param target null for {@code this}
   */
  public record MessageClaim(
      String text,
      @Nullable String operator,
      @Nullable Node target,
      Symbol message,
      List<Node> arguments)
      implements Claim {}

  /** A declaration among the claims; like them, it is executed only if assertions are enabled. */
  public static final class DeclarationClaim extends Node {
    private final Node declaration;

    public DeclarationClaim(Span span, Node declaration) {
      super(span);
      this.declaration = declaration;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      if (!frame.interpreter.assertionsDisabled()) {
        declaration.execute(frame);
      }
      return frame.interpreter.values().voidObject;
    }
  }

  private final Claim claim;

  public Assertion(Span span, Claim claim) {
    super(span);
    this.claim = claim;
  }

  @Override
  public UrbiObject execute(Frame frame) {
    Interpreter interpreter = frame.interpreter;
    if (interpreter.assertionsDisabled()) {
      return interpreter.values().voidObject;
    }
    if (claim instanceof MessageClaim sent) {
      check(frame, sent);
    } else {
      check(frame, (PlainClaim) claim);
    }
    return interpreter.values().voidObject;
  }

  private void check(Frame frame, PlainClaim whole) {
    UrbiObject value = whole.code.execute(frame);
    if (!holds(frame, value)) {
      // A construct that is printed on several lines is shown without its value.
      fail(
          frame,
          whole.text.indexOf('\n') >= 0
              ? null
              : whole.text + " == " + frame.interpreter.asPrintable(frame, value));
    }
  }

  private void check(Frame frame, MessageClaim sent) {
    UrbiObject target = sent.target == null ? frame.self : sent.target.execute(frame);
    Recorder recorder = new Recorder(sent, span());
    UrbiObject value = recorder.send(frame, target);
    if (!holds(frame, value)) {
      fail(frame, recorder.shown(frame, target, value));
    }
  }

  private boolean holds(Frame frame, UrbiObject value) {
    try {
      return Truth.of(frame, value);
    } catch (UrbiException e) {
      throw frame.located(e, span());
    }
  }

  /**
   * @param effective the claim with the values of its parts, or null
   */
  private void fail(Frame frame, @Nullable String effective) {
    Errors errors = frame.interpreter.errors();
    Errors.Builder error =
        frame.interpreter.assertionsShowValues() && effective != null
            ? errors.of(Problem.ASSERTION_FAILED_WITH, claim.text(), effective)
            : errors.of(Problem.ASSERTION_FAILED, claim.text());
    throw frame.located(error.build(), span());
  }

  /** The comparison that is true where the given one is false. */
  private static @Nullable String opposite(String operator) {
    return switch (operator) {
      case "==" -> "!=";
      case "!=" -> "==";
      case "===" -> "!==";
      case "!==" -> "===";
      case "<" -> ">=";
      case "<=" -> ">";
      case ">" -> "<=";
      case ">=" -> "<";
      case "~=" -> "!~=";
      case "in" -> "not in";
      case "not in" -> "in";
      default -> null;
    };
  }

  /** Sends the message of a claim and remembers the arguments that were evaluated. */
  private static final class Recorder implements CallSite {
    private final MessageClaim claim;
    private final Span span;
    private final Node[] nodes;
    private final UrbiObject[] seen;

    Recorder(MessageClaim claim, Span span) {
      this.claim = claim;
      this.span = span;
      this.seen = new UrbiObject[claim.arguments.size()];
      this.nodes = new Node[seen.length];
      for (int i = 0; i < nodes.length; i++) {
        int index = i;
        Node argument = claim.arguments.get(i);
        nodes[i] =
            new Node(argument.span()) {
              @Override
              public UrbiObject execute(Frame frame) {
                seen[index] = argument.execute(frame);
                return seen[index];
              }
            };
      }
    }

    UrbiObject send(Frame frame, UrbiObject target) {
      try {
        UrbiObject value = SlotLookup.find(frame, target, claim.message);
        if (value == null) {
          return Calls.fallback(frame, this, target, claim.message, nodes);
        }
        return value instanceof Code code
            ? Calls.call(frame, this, code, target, nodes)
            : Calls.plain(frame, this, value, target, nodes);
      } catch (UrbiException e) {
        throw frame.located(e, span);
      }
    }

    String shown(Frame frame, UrbiObject target, UrbiObject value) {
      Interpreter interpreter = frame.interpreter;
      String operator = claim.operator;
      String opposite = operator == null ? null : opposite(operator);
      if (operator != null && opposite != null) {
        String left = interpreter.asPrintable(frame, target);
        String right = seen[0] == null ? "?" : interpreter.asPrintable(frame, seen[0]);
        return operator.endsWith("in")
            ? right + " " + opposite + " " + left
            : left + " " + opposite + " " + right;
      }
      var text = new StringBuilder();
      if (claim.target != null) {
        text.append(interpreter.asPrintable(frame, target)).append('.');
      }
      text.append(claim.message.name());
      if (seen.length > 0) {
        text.append('(');
        for (int i = 0; i < seen.length; i++) {
          text.append(i > 0 ? ", " : "")
              .append(seen[i] == null ? "?" : interpreter.asPrintable(frame, seen[i]));
        }
        text.append(')');
      }
      return text + " == " + interpreter.asPrintable(frame, value);
    }

    @Override
    public String calledName() {
      return claim.message.name();
    }

    @Override
    public Span calledSpan() {
      return span;
    }

    @Override
    public Node[] argumentNodes() {
      return nodes;
    }
  }
}
