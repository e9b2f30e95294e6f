package org.urbi.lang.grammar;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/** The words that mean something to the scanner (manual, "Keywords"). */
class KeywordsTest {
  @Test
  void wordsAreThoseOfTheLexerAndTheirOtherSpellings() {
    Set<String> words =
        new TreeSet<>(List.of("and", "foreach", "loopn", "not_eq", "or", "xor", "xor_eq"));
    for (int token = UrbiscriptLexer.ASSERT; token <= UrbiscriptLexer.OR_EQ; token++) {
      String word = UrbiscriptLexer.VOCABULARY.getSymbolicName(token).toLowerCase(Locale.ROOT);
      assertEquals(token, Keywords.token(word), word);
      words.add(word);
    }
    assertEquals(words, new TreeSet<>(Keywords.all()));
  }

  @Test
  void differentSpellingsAreOneToken() {
    assertEquals(UrbiscriptLexer.FOR, Keywords.token("loopn"));
    assertEquals(UrbiscriptLexer.XOR_ASSIGN, Keywords.token("xor_eq"));
    assertEquals(UrbiscriptLexer.WORD, Keywords.token("While"));
  }

  @Test
  void wordsOfOnePlaceMayNameAnythingElsewhere() {
    for (String word : List.of("get", "import", "new", "package", "set")) {
      assertFalse(Keywords.keyword(word), word);
    }
    for (String word : List.of("while", "xor_eq", "goto", "static")) {
      assertTrue(Keywords.keyword(word), word);
    }
  }

  /** Printing looks up no other words. */
  @Test
  void wordsAreLowerCase() {
    Set<String> words = new TreeSet<>(Keywords.all());
    words.addAll(Keywords.refused());
    for (String word : words) {
      assertTrue(word.matches("[a-z_]+"), word);
    }
  }
}
