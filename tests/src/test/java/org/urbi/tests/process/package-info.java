/**
 * Programs in processes of their own, talking to one another: the whole system as a user has it.
 */
package org.urbi.tests.process;
