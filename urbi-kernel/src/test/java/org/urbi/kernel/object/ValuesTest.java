package org.urbi.kernel.object;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.NoSuchElementException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The values that every kernel has: new ones each time, of the right type, copied by clones. */
class ValuesTest {
  private final World world = new World();
  private final Values values = world.values();

  /** A key that is equal to others of its text. */
  private record Key(UrbiObject value, Comparable<?> rank, String text)
      implements UrbiDictionary.Key {
    @Override
    public boolean equals(Object other) {
      return other instanceof Key key && key.text.equals(text);
    }

    @Override
    public int hashCode() {
      return text.hashCode();
    }
  }

  private Key key(Comparable<?> rank, String text) {
    return new Key(values.string(text), rank, text);
  }

  // ------------------------------------------------------------------ constants

  @Test
  void constantsInheritFromWhatTheManualSays() {
    for (UrbiObject value :
        List.of(
            values.floatProto,
            values.stringProto,
            values.listProto,
            values.tupleProto,
            values.dictionaryProto,
            values.nil,
            values.booleanProto)) {
      assertSame(values.object, value.protos()[0]);
      assertEquals(1, value.protos().length);
    }
    assertEquals(0, values.object.protos().length);
    assertEquals(0, values.voidObject.protos().length);
    assertSame(values.voidObject, values.acceptedVoid.protos()[0]);
    assertTrue(values.trueObject.isA(values.booleanProto));
    assertTrue(values.falseObject.isA(values.booleanProto));
    assertSame(values.trueObject, values.bool(true));
    assertSame(values.falseObject, values.bool(false));
    assertNotSame(values.trueObject, values.falseObject);
  }

  @Test
  void everyEvaluationMakesANewObject() {
    assertNotSame(values.number(42), values.number(42));
    assertEquals(42, values.number(42).value());
    assertSame(values.floatProto, values.number(42).protos()[0]);
    assertSame(values.stringProto, values.string("").protos()[0]);
    assertSame(values.listProto, values.list(List.of()).protos()[0]);
    assertSame(values.listProto, values.listOf(new Elements(0)).protos()[0]);
    assertSame(values.tupleProto, values.tuple(List.of()).protos()[0]);
    assertSame(values.dictionaryProto, values.dictionary(Map.of()).protos()[0]);
    assertEquals(0, values.floatProto.value());
    assertEquals("", values.stringProto.value());
  }

  // ------------------------------------------------------------------ clones

  @Test
  void clonesHaveAPrototypeAndACopyOfTheValue() {
    UrbiFloat number = values.number(1.5);
    UrbiFloat sameNumber = assertInstanceOf(UrbiFloat.class, number.cloned());
    assertEquals(1.5, sameNumber.value());
    assertSame(number, sameNumber.protos()[0]);
    UrbiString string = values.string("text");
    UrbiString sameString = assertInstanceOf(UrbiString.class, string.cloned());
    string.setValue("other");
    assertEquals("text", sameString.value());
    assertSame(string, sameString.protos()[0]);
    UrbiList list = values.list(List.of(number));
    UrbiList sameList = assertInstanceOf(UrbiList.class, list.cloned());
    list.modify().clear();
    assertEquals(List.of(number), sameList.elements());
    UrbiTuple tuple = values.tuple(List.of(number, string));
    UrbiTuple sameTuple = assertInstanceOf(UrbiTuple.class, tuple.cloned());
    tuple.set(0, string);
    assertEquals(List.of(number, string), sameTuple.elements());
    assertEquals(List.of(string, string), tuple.elements());
    UrbiDictionary dictionary = values.dictionary(Map.of(key("a", "a"), number));
    UrbiDictionary sameDictionary = assertInstanceOf(UrbiDictionary.class, dictionary.cloned());
    dictionary.modify().clear();
    assertEquals(Map.of(key("a", "a"), number), sameDictionary.entries());
    assertEquals(Map.of(), dictionary.entries());
    UrbiHash hash = new UrbiHash(values.object.cloneShape(), 17);
    UrbiHash sameHash = assertInstanceOf(UrbiHash.class, hash.cloned());
    hash.combine(3);
    assertEquals(17, sameHash.code());
    assertSame(hash, sameHash.protos()[0]);
  }

  // ------------------------------------------------------------------ strings

  /** Pieces below and beyond the length from which strings share a buffer. */
  @ParameterizedTest
  @ValueSource(ints = {1, 100, 511, 512, 513, 1023, 1024, 5000})
  void stringsGrowAndTheirBeginningsStay(int length) {
    String a = "a".repeat(length);
    UrbiString first = values.string(a);
    UrbiString second = values.concatenation(first, "b".repeat(length));
    UrbiString third = values.concatenation(second, "c");
    UrbiString fork = values.concatenation(second, "d");
    UrbiString other = values.concatenation(first, "e");
    assertEquals(a, first.value());
    assertEquals(a + "b".repeat(length), second.value());
    assertEquals(a + "b".repeat(length) + "c", third.value());
    assertEquals(a + "b".repeat(length) + "d", fork.value());
    assertEquals(a + "e", other.value());
    assertSame(values.stringProto, third.protos()[0]);
  }

  @Test
  void aStringThatIsChangedLeavesThoseMadeOfItAlone() {
    UrbiString first = values.string("a".repeat(2000));
    UrbiString second = values.concatenation(first, "b");
    second.setValue("c".repeat(1500));
    UrbiString third = values.concatenation(second, "d");
    first.setValue("e".repeat(1200));
    UrbiString fourth = values.concatenation(first, "f");
    assertEquals("c".repeat(1500), second.value());
    assertEquals("c".repeat(1500) + "d", third.value());
    assertEquals("e".repeat(1200) + "f", fourth.value());
  }

  /** Or a text of n pieces would take n² steps: this one would be 20 GB of copies. */
  @Test
  void aTextOfManyPiecesIsCopiedFewTimes() {
    UrbiString text = values.string("");
    for (int i = 0; i < 60_000; i++) {
      text = values.concatenation(text, "1234567890");
    }
    assertEquals(600_000, text.value().length());
  }

  // ------------------------------------------------------------------ lists and tuples

  @Test
  void listsAreCopiedUnlessTheyAreTakenOver() {
    Elements elements = new Elements(List.of(values.nil));
    UrbiList copy = values.list(elements);
    UrbiList taken = values.listOf(elements);
    elements.add(values.object);
    assertEquals(1, copy.elements().size());
    assertEquals(2, taken.elements().size());
    assertSame(elements, taken.modify());
  }

  @Test
  void tuplesHaveAFixedNumberOfElements() {
    UrbiTuple tuple = values.tuple(List.of(values.nil, values.object));
    assertEquals(2, tuple.size());
    assertSame(values.nil, tuple.get(0));
    assertSame(values.object, tuple.get(1));
    tuple.setElements(List.of(values.object));
    assertEquals(1, tuple.size());
    assertSame(values.object, tuple.get(0));
  }

  // ------------------------------------------------------------------ dictionaries

  @Test
  void keysComeStringsFirstThenNumbersThenTheOthersAsTheyCame() {
    Map<UrbiDictionary.Key, UrbiObject> entries = new LinkedHashMap<>();
    for (Key key :
        List.of(
            key(null, "other2"),
            key(10.0, "10"),
            key("b", "b"),
            key(null, "other1"),
            key(9.0, "9"),
            key("a", "a"))) {
      entries.put(key, values.nil);
    }
    UrbiDictionary dictionary = values.dictionary(entries);
    entries.clear();
    assertEquals(
        List.of("a", "b", "9", "10", "other2", "other1"),
        dictionary.sorted().stream().map(entry -> ((Key) entry.getKey()).text()).toList());
    assertEquals(6, dictionary.entries().size());
  }

  // ------------------------------------------------------------------ hashes

  @Test
  void hashesFitIntoAFloatAndDependOnTheOrder() {
    UrbiHash hash = new UrbiHash(values.object.cloneShape(), -1);
    assertEquals((1L << 52) - 1, hash.code());
    assertEquals(0x1234, new UrbiHash(values.object.cloneShape(), 0x1234).code());
    assertNotEquals(UrbiHash.mix(1, 2), UrbiHash.mix(2, 1));
    assertNotEquals(UrbiHash.mix(1, 2), UrbiHash.mix(1, 3));
    long code = UrbiHash.mix(hash.code(), 5);
    hash.combine(5);
    assertEquals(code, hash.code());
    for (long i = 1; i < 100; i++) {
      long mixed = UrbiHash.mix(i * 0x123456789L, -i);
      assertTrue(mixed >= 0 && mixed < 1L << 52);
      assertEquals(mixed, (long) (double) mixed);
    }
  }

  /** Codes are shown, so they are the same in every version. */
  @Test
  void theCodeOfAHashIsKnown() {
    long product = (2 * 31 + 3) * 0x9E3779B97F4A7C15L;
    assertEquals((product ^ product >>> 29) & (1L << 52) - 1, UrbiHash.mix(2, 3));
  }

  // ------------------------------------------------------------------ modes of blending

  @ParameterizedTest
  @CsvSource({
    "MIX,mix,0",
    "ADD,add,1",
    "DISCARD,discard,2",
    "QUEUE,queue,3",
    "CANCEL,cancel,4",
    "NORMAL,normal,5"
  })
  void modesHaveANameAndANumber(BlendMode mode, String name, double number) {
    assertEquals(name, mode.text());
    assertSame(mode, BlendMode.of(values.string(name)));
    assertSame(mode, BlendMode.of(values.number(number)));
  }

  @ParameterizedTest
  @EnumSource
  void whatIsNoModeIsNone(BlendMode mode) {
    assertNull(BlendMode.of(values.string(mode.name())));
    assertNull(BlendMode.of(values.number(mode.ordinal() + 0.5)));
    assertNull(BlendMode.of(values.number(mode.ordinal() + 6)));
    assertNull(BlendMode.of(values.nil));
  }

  // ------------------------------------------------------------------ what a kernel shares

  @Test
  void namesAreTheSameInOneKernelAndOthersInAnother() {
    assertSame(world.symbol("a"), world.symbol("a"));
    assertNotSame(world.symbol("a"), world.symbol("b"));
    assertNotSame(world.symbol("a"), new World().symbol("a"));
    assertEquals("a", world.symbol("a").name());
    assertEquals("a", world.symbol("a").toString());
  }

  @Test
  void countersBeginWhereTheyAreToldAndGoUpByOne() {
    assertEquals(5, world.count("lobbies", 5));
    assertEquals(6, world.count("lobbies", 5));
    assertEquals(0, world.count("files", 0));
    assertEquals(7, world.count("lobbies", 0));
  }

  @Test
  void prototypesOfTheLibraryAreKnownByName() {
    assertNull(world.findPrototype("Date"));
    assertThrows(NoSuchElementException.class, () -> world.prototype("Date"));
    world.declarePrototype("Date", values.nil);
    assertSame(values.nil, world.prototype("Date"));
    assertSame(values.nil, world.findPrototype("Date"));
    assertNull(world.findPrototype("Path"));
  }

  @Test
  void theSameWorldHasTheSameRandomNumbersAndTheSameOrphans() {
    assertNotNull(world.randomNumbers());
    assertSame(world.randomNumbers(), world.randomNumbers());
    assertSame(world.orphanShape(), world.orphanShape());
    UrbiObject orphan = new UrbiObject(world.orphanShape());
    assertFalse(orphan.isA(values.object));
    assertEquals(0, orphan.protos().length);
  }
}
