import { expect, test } from 'vitest';
import { simulationFromParameters, simulationToParameters, USUAL } from './simulation.ts';

test('the sliders survive the address', () => {
  const setup = {
    ...USUAL,
    heightM: 1.25,
    restitution: 0.8,
    body: 'moon',
    air: 0.5,
    law: 'knee:0.95,1.5,0.02',
  };
  const written = simulationToParameters(setup).toString();
  expect(written).toBe('height_cm=125&e=0.8&air_percent=50&body=moon&law=knee%3A0.95%2C1.5%2C0.02');
  expect(simulationFromParameters(new URLSearchParams(written))).toEqual(setup);
});

test('what lies beyond a slider stays at its end, and nonsense at its usual place', () => {
  const setup = simulationFromParameters(new URLSearchParams('e=7&height_cm=x&ball=%3Cb%3E'));
  expect(setup.restitution).toBe(0.99);
  expect(setup.heightM).toBe(USUAL.heightM);
  expect(setup.ball).toBe(USUAL.ball);
});
