/**
 * Whole-system tests: dialogues with a kernel as in the manual, the same output on every machine,
 * and a console that survives whatever it is fed.
 */
package org.urbi.tests;
