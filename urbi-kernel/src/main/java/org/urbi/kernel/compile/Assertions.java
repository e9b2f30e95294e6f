package org.urbi.kernel.compile;

import static java.util.Objects.requireNonNullElseGet;

import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.Assertion;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.print.Printer;

/** Compiles the claims of assertions (manual, "Assertions"). */
final class Assertions {
  private static final Set<String> COMPARISONS =
      Set.of("==", "!=", "===", "!==", "<", "<=", ">", ">=", "~=", "=~=");

  private final Compilation compilation;

  Assertions(Compilation compilation) {
    this.compilation = compilation;
  }

  /** A claim, split into those parts that the message of its failure shows one by one. */
  Assertion.Claim claim(Ast ast, LexicalScope block) {
    if (!(ast instanceof Ast.Message message)
        || (message.target() == null && block.find(message.name()) != null)) {
      return new Assertion.PlainClaim(text(ast), compilation.operand(ast, block));
    }
    return new Assertion.MessageClaim(
        text(ast),
        operator(message),
        message.target() == null
            ? compilation.receivers.implicit(message.name(), message.span(), block)
            : compilation.operand(message.target(), block),
        compilation.interpreter().world().symbol(message.name()),
        message.arguments() == null
            ? List.of()
            : List.of(compilation.all(message.arguments(), block)));
  }

  /** The operator as it was written, if the claim compares or looks into a container; or null. */
  private static @Nullable String operator(Ast.Message message) {
    if (message.target() == null
        || message.arguments() == null
        || message.arguments().size() != 1) {
      return null;
    }
    if (COMPARISONS.contains(message.name())) {
      return message.name();
    }
    // "a in b" is "b.has(a)": only the text tells them apart.
    String written = message.nameSpan().text();
    return switch (message.name()) {
      case "has" -> written.equals("in") ? "in" : null;
      case "hasNot" -> written.startsWith("not") ? "not in" : null;
      default -> null;
    };
  }

  /**
   * How the message names the claim: an operator by its operands, {@code &&} and {@code ||} by
   * their result.
   */
  private static String text(Ast ast) {
    if (ast instanceof Ast.And and) {
      return logical(and.left(), Printer.print(and.right()), "'$t1'");
    }
    if (ast instanceof Ast.Or or) {
      return logical(or.left(), "'$t1'", Printer.print(or.right()));
    }
    return ast instanceof Ast.Message message
        ? requireNonNullElseGet(operation(message), () -> Printer.print(ast))
        : Printer.print(ast);
  }

  /** An operator with its operands, as it was written; null for another message. */
  private static @Nullable String operation(Ast.Message message) {
    Ast left = message.target();
    List<Ast> arguments = message.arguments();
    String operator = operator(message);
    if (left == null || arguments == null || operator == null) {
      return null;
    }
    String target = Printer.print(left);
    String argument = Printer.print(arguments.getFirst());
    return COMPARISONS.contains(operator)
        ? target + " " + operator + " " + argument
        : argument + " " + operator + " " + target;
  }

  private static String logical(Ast left, String whenTrue, String whenFalse) {
    return "var '$t1' = "
        + Printer.print(left)
        + " | if ('$t1')\n{ "
        + whenTrue
        + " }\nelse\n{ "
        + whenFalse
        + " }";
  }
}
