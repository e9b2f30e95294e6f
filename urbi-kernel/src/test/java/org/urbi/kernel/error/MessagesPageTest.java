package org.urbi.kernel.error;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.urbi.lang.problem.SyntaxProblem;
import org.urbi.lang.problem.Template;

/** Keeps docs/messages.md what the catalogues say; {@code -Drenew=true} writes it anew. */
class MessagesPageTest {
  private static final Path PAGE = Path.of("..", "docs", "messages.md");

  private static final String BEGINNING =
      """
      # Messages

      All that the language says when something is wrong, by what it becomes. Generated from the
      catalogues, `Problem` in the kernel and `SyntaxProblem` in the parser; do not edit. What is in
      braces is filled in.
      """;

  private final StringBuilder page = new StringBuilder(BEGINNING);

  @Test
  void pageIsUpToDate() throws IOException {
    for (SyntaxProblem.Kind kind : SyntaxProblem.Kind.values()) {
      section(kind == SyntaxProblem.Kind.ERROR ? "Errors of the parser" : "Warnings of the parser");
      for (SyntaxProblem problem : SyntaxProblem.values()) {
        if (problem.kind() == kind) {
          row(problem.template(), problem.hint());
        }
      }
    }
    for (ProblemKind kind : ProblemKind.values()) {
      section(title(kind));
      for (Problem problem : Problem.values()) {
        if (problem.kind() == kind) {
          row(problem.template(), problem.hint());
        }
      }
    }
    if (Boolean.getBoolean("renew")) {
      Files.writeString(PAGE, page);
    }
    assertEquals(
        page.toString(),
        Files.readString(PAGE),
        "docs/messages.md is stale: mvn -pl urbi-kernel -am test -Dtest=MessagesPageTest"
            + " -Dsurefire.failIfNoSpecifiedTests=false -Drenew=true");
  }

  private static String title(ProblemKind kind) {
    return switch (kind) {
      case WARNING -> "Warnings";
      case LINE -> "Lines by themselves";
      case PART -> "Parts of other messages";
      default -> "`" + kind.type() + "`";
    };
  }

  private void section(String title) {
    page.append("\n## ").append(title).append("\n\n| message | what to do |\n|---|---|\n");
  }

  private void row(Template template, Optional<String> hint) {
    page.append("| ")
        .append(code(template.text()))
        .append(" | ")
        .append(hint.map(MessagesPageTest::escaped).orElse(""))
        .append(" |\n");
  }

  private static String escaped(String text) {
    return text.replace("\\", "\\\\").replace("|", "\\|").replace("*", "\\*").replace("<", "&lt;");
  }

  /** Text as code, even if it has backticks. */
  private static String code(String text) {
    String escaped = text.replace("|", "\\|");
    return text.indexOf('`') < 0 ? "`" + escaped + "`" : "`` " + escaped + " ``";
  }
}
