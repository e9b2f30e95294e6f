package org.urbi.lang.grammar;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/** What is for editors has the words of the scanner, and no others. */
class EditorsTest {
  private static final Path EDITORS = Path.of("..", "editors");

  /** The words in what an expression finds in a file: its first group. */
  private static Set<String> words(String file, String expression) throws IOException {
    return Pattern.compile(expression)
        .matcher(Files.readString(EDITORS.resolve(file)))
        .results()
        .flatMap(found -> Pattern.compile("\\w+").matcher(found.group(1)).results())
        .map(word -> word.group())
        .collect(Collectors.toCollection(TreeSet::new));
  }

  private static Set<String> grammar(String scopes) throws IOException {
    return words(
        "vscode/syntaxes/urbiscript.tmLanguage.json",
        "\"name\": \"(?:" + scopes + ")[^\"]*\",\\s*\"match\": \"[^\"]*?\\(\\?:((?:\\w+[|)])+)");
  }

  private static Set<String> emacs(String list) throws IOException {
    return words(
        "emacs/urbiscript-mode.el", "\\(defconst urbiscript-" + list + "\\s+'\\(([^)]*)\\)");
  }

  @Test
  void theGrammarHasTheWords() throws IOException {
    assertEquals(
        new TreeSet<>(Keywords.all()),
        grammar("keyword[.](?:control|operator[.]word|other)|storage|variable[.]language"));
    assertEquals(
        new TreeSet<>(Keywords.refused()), grammar("invalid[.](?:deprecated|illegal[.]reserved)"));
  }

  @Test
  void emacsHasTheWords() throws IOException {
    Set<String> words = emacs("keywords");
    words.addAll(emacs("contextual"));
    assertEquals(new TreeSet<>(Keywords.all()), words);
    assertEquals(new TreeSet<>(Keywords.refused()), emacs("refused"));
    assertEquals(grammar("constant[.]language"), emacs("constants"));
  }

  @Test
  void wordsOfOnePlaceAreToldApart() throws IOException {
    assertEquals(emacs("contextual"), grammar("keyword[.]other[.]contextual"));
    assertEquals(
        List.of(),
        emacs("contextual").stream().filter(Keywords::keyword).collect(Collectors.toList()));
  }
}
